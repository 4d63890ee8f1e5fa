// Marked edges: lines of a few pixels, which are faint where the surface hides them.

import {BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments} from 'three';
import {LineMaterial} from 'three/examples/jsm/lines/LineMaterial.js';
import {LineSegments2} from 'three/examples/jsm/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const widthInPixels = 3;
// If there are more edges, they are drawn as thin lines only, because so many lines are visible
// enough. Without a graphics card, 2000 wide lines take 0.4 s of processor time for each picture.
const mostWide = 2000;
// At a higher opacity, lines on the far side look like lines on the near side.
const opacityOfHidden = 0.5;

// Returns faint lines, one pixel wide: the ends of wider lines overlap, which would be visible in
// faint lines.
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

  // Sets the lines. Each kind has a CSS color and `segments`, six numbers for each line.
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
