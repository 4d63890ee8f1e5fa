"""Writes a tetrahedron in formats or encodings that the suite reads and does not write.

    foreign_files.py FOLDER

Uses Python's standard library only."""
import base64
import struct
import sys
import zipfile
import zlib

POSITIONS = [(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)]
FACES = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
NUMBERS = [x for position in POSITIONS for x in position]
CORNERS = [corner for face in FACES for corner in face]


class Vtp:
    """A file of VTK's XML format in a given encoding and byte order, compressed or not."""

    def __init__(self, encoding, big, packed, wide):
        self.encoding, self.packed = encoding, packed
        self.order, self.size = ">" if big else "<", "Q" if wide else "I"
        self.attributes = 'byte_order="%s"' % ("BigEndian" if big else "LittleEndian")
        if wide:
            self.attributes += ' header_type="UInt64"'
        if packed:
            self.attributes += ' compressor="vtkZLibDataCompressor"'
        self.appended = b""

    def stored(self, raw):
        if not self.packed:
            return [struct.pack(self.order + self.size, len(raw)) + raw]
        blocks = [zlib.compress(raw[at:at + 16]) for at in range(0, len(raw), 16)]
        sizes = [len(blocks), 16, len(raw) % 16] + [len(block) for block in blocks]
        return [struct.pack("%s%d%s" % (self.order, len(sizes), self.size), *sizes), b"".join(blocks)]

    def array(self, kind, code, name, width, values):
        start = '<DataArray type="%s" Name="%s" NumberOfComponents="%d" ' % (kind, name, width)
        if self.encoding == "ascii":
            return start + 'format="ascii">%s</DataArray>' % " ".join(map(str, values))
        parts = self.stored(struct.pack("%s%d%s" % (self.order, len(values), code), *values))
        if self.encoding != "raw":
            parts = [base64.b64encode(part) for part in parts]
        if self.encoding == "inline":
            return start + 'format="binary">\n%s\n</DataArray>' % b"".join(parts).decode()
        offset = len(self.appended)
        self.appended += b"".join(parts)
        return start + 'format="appended" offset="%d"/>' % offset

    def bytes(self):
        piece = '<PointData Scalars="c">' + self.array("UInt8", "B", "c", 3, [255, 0, 51] * 4)
        piece += "</PointData><Points>" + self.array("Float32", "f", "p", 3, NUMBERS)
        piece += "</Points><Polys>" + self.array("Int64", "q", "connectivity", 1, CORNERS)
        piece += self.array("Int32", "i", "offsets", 1, [3, 6, 9, 12]) + "</Polys>"
        text = '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" %s>' % self.attributes
        text += "<PolyData><Piece>%s</Piece></PolyData>" % piece
        end = b""
        if self.appended:
            kind = b"raw" if self.encoding == "raw" else b"base64"
            end = b'<AppendedData encoding="' + kind + b'">\n  _' + self.appended + b"</AppendedData>"
        return text.encode() + end + b"</VTKFile>\n"


def write_vtp(folder):
    for encoding in ("ascii", "inline", "raw", "appended"):
        for bits in range(8):
            big, packed, wide = bits & 1, bits & 2, bits & 4
            with open("%s/%s%d.vtp" % (folder, encoding, bits), "wb") as file:
                file.write(Vtp(encoding, big, packed, wide).bytes())


def write_vtk(folder):
    head = "# vtk DataFile Version %s\ntetrahedron\n%s\nDATASET %s\n"
    points = "POINTS 4 float\n%s\n" % " ".join(map(str, NUMBERS))
    list_of_faces = " ".join("3 %d %d %d" % face for face in FACES)
    with open(folder + "/text.vtk", "w") as file:
        file.write(head % ("3.0", "ASCII", "POLYDATA") + points + "POLYGONS 4 16\n" + list_of_faces)
    with open(folder + "/grid.vtk", "w") as file:
        file.write(head % ("2.0", "ASCII", "UNSTRUCTURED_GRID") + points + "CELLS 4 16\n")
        file.write(list_of_faces + "\nCELL_TYPES 4\n5 5 5 5\n")
    with open(folder + "/binary.vtk", "wb") as file:
        file.write((head % ("5.1", "BINARY", "POLYDATA") + "POINTS 4 double\n").encode())
        file.write(struct.pack(">12d", *NUMBERS) + b"\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n")
        file.write(struct.pack(">5q", 0, 3, 6, 9, 12) + b"\nCONNECTIVITY vtktypeint64\n")
        file.write(struct.pack(">12q", *CORNERS) + b"\n")


def write_3mf(folder):
    vertices = "".join('<vertex x="%g" y="%g" z="%g"/>' % position for position in POSITIONS)
    faces = "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % face for face in FACES)
    core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    model = '<model unit="centimeter" xmlns="%s"><resources><object id="4"><mesh><vertices>%s' % (
        core, vertices)
    model += "</vertices><triangles>%s</triangles></mesh></object></resources>" % faces
    model += '<build><item objectid="4"/></build></model>'
    kind = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    relations = '<Relationships><Relationship Target="/3D/a.model" Type="%s"/></Relationships>' % kind
    for name, method in (("stored", zipfile.ZIP_STORED), ("deflated", zipfile.ZIP_DEFLATED)):
        with zipfile.ZipFile("%s/%s.3mf" % (folder, name), "w", method) as archive:
            archive.writestr("_rels/.rels", relations)
            archive.writestr("3D/a.model", model)
    # If the file cannot seek, zipfile writes sizes after the data.
    with open(folder + "/streamed.3mf", "wb") as file:
        class Pipe:
            def write(self, data):
                return file.write(data)

            def flush(self):
                file.flush()
        with zipfile.ZipFile(Pipe(), "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("_rels/.rels", relations)
            archive.writestr("3D/a.model", model)


def write_pcd(folder):
    head = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\nDATA "
    with open(folder + "/text.pcd", "w") as file:
        file.write(head + "ascii\n" + "".join("%g %g %g\n" % position for position in POSITIONS))
    with open(folder + "/binary.pcd", "wb") as file:
        file.write((head + "binary\n").encode() + struct.pack("<12f", *NUMBERS))
    columns = struct.pack("<12f", *[position[axis] for axis in range(3) for position in POSITIONS])
    packed = b"".join(bytes([len(columns[at:at + 32]) - 1]) + columns[at:at + 32]
                      for at in range(0, len(columns), 32))
    with open(folder + "/packed.pcd", "wb") as file:
        file.write((head + "binary_compressed\n").encode())
        file.write(struct.pack("<II", len(packed), len(columns)) + packed)


for write in (write_vtp, write_vtk, write_3mf, write_pcd):
    write(sys.argv[1])
