"""Builds the source archive and the wheel of the module: the hooks of PEP 517, which run git and CMake.

The wheel's module contains all libraries but those of PEP 600's manylinux. The setting `build` names a
folder that has been built before (`-C build=build`); without it the library is compiled first, in
`build-wheel`. Needs the packages of `scripts/setup --python`.
"""
import base64
import hashlib
import io
import platform
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAME = 'transformesh'
TARGET = 'wheel_module'

# The shared libraries that PEP 600 allows and that the module needs. Other shared libraries may be
# missing on a user's machine.
ALLOWED = {'libc.so.6', 'libm.so.6', 'libpthread.so.0', 'ld-linux-x86-64.so.2', 'ld-linux-aarch64.so.1'}

# Modification time of all files in the wheel, so that equal modules give equal wheels. It is the
# earliest time that a zip file can store.
FIRST_ZIP_TIME = (1980, 1, 1, 0, 0, 0)


def version():
    text = (ROOT / 'CMakeLists.txt').read_text()
    return re.search(r'project\(transformesh VERSION ([0-9.]+)', text).group(1)


def metadata():
    return f'''Metadata-Version: 2.1
Name: {NAME}
Version: {version()}
Summary: Mesh evolution: exact removal of self-intersections, remeshing, morphing, reconstruction
License: GPL-3.0-only
Requires-Python: >=3.9
Requires-Dist: numpy
Description-Content-Type: text/markdown

{(ROOT / 'docs/python.md').read_text()}'''


def wheel_tag():
    python = 'cp' + sysconfig.get_config_var('py_version_nodot')
    libc, libc_version = platform.libc_ver()
    if libc != 'glibc':
        raise SystemExit(f'wheels are built with glibc, and this Python uses {libc or "another libc"}')
    major, minor = libc_version.split('.')[:2]
    return f'{python}-{python}-manylinux_{major}_{minor}_{platform.machine()}'


def run(*command):
    subprocess.run([str(word) for word in command], check=True, cwd=ROOT)


def configure(folder):
    run('cmake', '-S', ROOT, '-B', folder, '-G', 'Ninja', '-DBUILD_TESTING=OFF',
        f'-DPython3_EXECUTABLE={sys.executable}')


def check_libraries(module):
    output = subprocess.run(['readelf', '-d', module], check=True, capture_output=True, text=True).stdout
    others = set(re.findall(r'\(NEEDED\).*\[(.*)\]', output)) - ALLOWED
    if others:
        raise SystemExit(f'the module would load {", ".join(sorted(others))}: install their static libraries')


def build_module(config_settings):
    """Returns the folder of the build, whose folder wheel/transformesh then holds the module."""
    folder = (config_settings or {}).get('build')
    if folder is None:
        folder = ROOT / 'build-wheel'
        configure(folder)
    # Tests that run at the same time may build in this folder, which Ninja itself does not lock.
    run('flock', folder, 'cmake', '--build', folder, '--target', TARGET)
    return Path(folder)


def package_files(build):
    """Yields (name in the wheel, bytes) of the package."""
    for name in ('__init__.py', '_advice.py', '_errors.py', '_functions.py', '_transformesh.pyi', 'py.typed'):
        yield f'{NAME}/{name}', (ROOT / 'python' / NAME / name).read_bytes()
    for module in sorted((build / 'wheel' / NAME).glob('_transformesh.*.so')):
        check_libraries(module)
        with tempfile.NamedTemporaryFile() as stripped:
            run('strip', '-o', stripped.name, module)
            yield f'{NAME}/{module.name}', Path(stripped.name).read_bytes()


def licence_files(build, info):
    yield f'{info}/licenses/LICENSE', (ROOT / 'LICENSE').read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        run(ROOT / 'scripts/packaging/licences', build, TARGET, folder)
        for path in sorted(Path(folder).iterdir()):
            yield f'{info}/licenses/{path.name}', path.read_bytes()


def record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()
    return f'{name},sha256={digest},{len(data)}\n'


def write_wheel(path, files, info):
    record = io.StringIO()
    with zipfile.ZipFile(path, 'w', zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        def add(name, data):
            entry = zipfile.ZipInfo(name, FIRST_ZIP_TIME)
            entry.external_attr = (0o100755 if name.endswith('.so') else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)

        for name, data in files:
            add(name, data)
            record.write(record_line(name, data))
        record.write(f'{info}/RECORD,,\n')
        add(f'{info}/RECORD', record.getvalue().encode())


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    tag = wheel_tag()
    build = build_module(config_settings)
    info = f'{NAME}-{version()}.dist-info'
    about = f'Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\nTag: {tag}\n'
    files = [*package_files(build), *licence_files(build, info),
             (f'{info}/METADATA', metadata().encode()), (f'{info}/WHEEL', about.encode())]
    wheel = f'{NAME}-{version()}-{tag}.whl'
    write_wheel(Path(wheel_directory) / wheel, files, info)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """Archives the committed files of the clone."""
    base = f'{NAME}-{version()}'
    path = Path(sdist_directory).resolve() / f'{base}.tar.gz'
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / 'PKG-INFO').write_text(metadata())
        run('git', 'archive', f'--prefix={base}/', f'--add-file={folder}/PKG-INFO', '--output', path, 'HEAD')
    return path.name
