// Edges that are pointed out: lines of a few pixels, faint where the surface hides them.

import {Color, Group} from 'three';
import {LineMaterial} from 'three/examples/jsm/lines/LineMaterial.js';
import {LineSegments2} from 'three/examples/jsm/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const widthInPixels = 3;
// Low enough that lines on the far side are not taken for lines on the near side.
const opacityOfHidden = 0.3;

function materialOf(color, isHidden) {
  return new LineMaterial({
    color: new Color(color), linewidth: widthInPixels, transparent: true, depthWrite: false,
    depthTest: !isHidden, opacity: isHidden ? opacityOfHidden : 1,
  });
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
      const geometry = new LineSegmentsGeometry().setPositions(segments);
      for (const isHidden of [true, false]) this.#add(geometry, materialOf(color, isHidden), isHidden ? 2 : 3);
    }
  }

  #add(geometry, material, order) {
    const line = new LineSegments2(geometry, material);
    line.frustumCulled = false;
    line.renderOrder = order;
    this.group.add(line);
  }
}
