// Meshes that the page makes itself, for a first look: the programs that make them, and the files to open.

const step = (program, words, reads = []) => ({program, words, reads});

// The hole and the flipped part are in front, to the left, where the page shows what was before.
const patch = '--box=-2,-2,0.3,0.2,0.2,0.9';

export const examples = [
  {
    title: 'A folded torus', text: 'runs through itself', opens: ['folded-torus.stl'],
    steps: [step('tm-shape', ['folded', 'torus', '--faces=12000', '-o', 'folded-torus.stl'])],
  },
  {
    title: 'A broken ball', text: 'has a hole and a flipped part', opens: ['broken-ball.stl'],
    steps: [
      step('tm-shape', ['sphere', '--faces=6000', '-o', 'ball.ply']),
      step('tm-select', ['--plane=0,1,0,-0.9', 'ball.ply', '-o', 'open.ply'], ['ball.ply']),
      step('tm-select', [patch, 'open.ply', '-o', 'patch.ply'], ['open.ply']),
      step('tm-select', [patch, '--invert', 'open.ply', '-o', 'rest.ply'], ['open.ply']),
      step('tm-stitch', ['--flip', 'patch.ply', '-o', 'turned.ply'], ['patch.ply']),
      step('tm-cat', ['rest.ply', 'turned.ply', '-o', 'broken-ball.stl'], ['rest.ply', 'turned.ply']),
    ],
  },
  {
    title: 'Two solids', text: 'to combine or to morph', opens: ['ball.ply', 'torus.ply'],
    steps: [
      step('tm-shape', ['sphere', '--faces=3000', '-o', 'ball.ply']),
      step('tm-shape', ['torus', '--faces=3000', '-o', 'torus.ply']),
    ],
  },
];
