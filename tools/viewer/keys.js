// Keys that turn and zoom a view, with the functions that they call.

export function keysOfView(view) {
  return {
    ArrowLeft: () => view.turn(-10, 0), ArrowRight: () => view.turn(10, 0),
    ArrowUp: () => view.turn(0, 10), ArrowDown: () => view.turn(0, -10),
    '+': () => view.turn(0, 0, 1.2), '=': () => view.turn(0, 0, 1.2), '-': () => view.turn(0, 0, 1 / 1.2),
    0: () => view.reset(),
  };
}
