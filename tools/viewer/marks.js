// Edges that are pointed out: lines of a few pixels, faint where the surface hides them.

import {BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments} from 'three';
import {LineMaterial} from 'three/examples/jsm/lines/LineMaterial.js';
import {LineSegments2} from 'three/examples/jsm/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const widthInPixels = 3;
// Without a graphics card 2000 wide lines take 0.4 s of a processor, at each picture. Thousands of edges
// are seen as thin lines, too.
const mostWide = 2000;
// Low enough that lines on the far side are not taken for lines on the near side.
const opacityOfHidden = 0.5;

// As thin as can be, also because ends of wide lines overlap, which shows where they are faint.
function faintLines(segments, color) {
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(segments, 3));
  const material = new LineBasicMaterial({color, transparent: true, opacity: opacityOfHidden, depthTest: false, depthWrite: false});
  return new LineSegments(geometry, material);
}

function wideLines(segments, color) {
  return new LineSegments2(new LineSegmentsGeometry().setPositions(segments),
    new LineMaterial({color, linewidth: widthInPixels, transparent: true, depthWrite: false}));
}

export class Marks {
  constructor() {
    this.group = new Group();
  }

  // `kinds` have a CSS color and `segments`: six numbers for each line.
  set(kinds) {
    for (const line of this.group.children) {
      line.geometry.dispose();
      line.material.dispose();
    }
    this.group.clear();
    for (const {color, segments} of kinds) {
      if (segments.length === 0) continue;
      this.#add(faintLines(segments, new Color(color)), 2);
      if (segments.length <= 6 * mostWide) this.#add(wideLines(segments, new Color(color)), 3);
    }
  }

  #add(lines, order) {
    lines.frustumCulled = false;
    lines.renderOrder = order;
    this.group.add(lines);
  }
}
