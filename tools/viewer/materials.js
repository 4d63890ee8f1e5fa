// Materials of surfaces. Lighting is computed at vertices. With software rendering, this is three
// times as fast as the materials of three.js. Colors are squared sRGB values.

import {Color, DoubleSide, ShaderMaterial} from 'three';

const vertexShader = `
  varying vec3 tone;
  varying vec2 lit;
  varying vec3 eye;
  uniform vec3 tint;

  float light(vec3 n) {
    return 0.30 + 0.22 * (0.5 + 0.5 * n.y) + 0.52 * max(dot(n, vec3(-0.3244, 0.4867, 0.8111)), 0.0);
  }

  void main() {
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    eye = place.xyz;
    vec3 n = normalize(normalMatrix * normal);
    lit = vec2(light(n), light(-n));
    tone = tint;
    #ifdef USE_COLOR
      tone *= color;
    #endif
    gl_Position = projectionMatrix * place;
  }`;

const fragmentShader = `
  varying vec3 tone;
  varying vec2 lit;
  varying vec3 eye;
  uniform float opacity;

  float light(vec3 n) {
    return 0.30 + 0.22 * (0.5 + 0.5 * n.y) + 0.52 * max(dot(n, vec3(-0.3244, 0.4867, 0.8111)), 0.0);
  }

  void main() {
    #ifdef FLAT
      float share = light(normalize(cross(dFdx(eye), dFdy(eye))));
    #else
      float share = gl_FrontFacing ? lit.x : lit.y;
    #endif
    gl_FragColor = vec4(sqrt(tone * share), opacity);
  }`;

export function surfaceMaterial(options = {}) {
  return new ShaderMaterial({
    vertexShader, fragmentShader, side: DoubleSide,
    uniforms: {tint: {value: new Color(1, 1, 1)}, opacity: {value: options.opacity ?? 1}},
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, ...options,
  });
}

// Returns the squared sRGB values of a CSS color.
export function squareOf(css) {
  const color = new Color(css).convertLinearToSRGB();
  return color.multiply(color);
}

// Returns red, green and blue of a CSS color, 0 to 255.
export function bytesOfColor(css) {
  const {r, g, b} = new Color(css).convertLinearToSRGB();
  return [r, g, b].map((share) => Math.round(255 * share));
}

export function setTint(material, css) {
  material.uniforms.tint.value = squareOf(css);
}

export function setVertexColors(material, areThere) {
  if (material.vertexColors === areThere) return;
  material.vertexColors = areThere;
  material.needsUpdate = true;
}

export function setFlat(material, isFlat) {
  if ((material.defines.FLAT !== undefined) === isFlat) return;
  material.defines = isFlat ? {FLAT: 1} : {};
  material.needsUpdate = true;
}
