// Formats numbers, and finds numbers in sorted lists.

const whole = new Intl.NumberFormat('en', {maximumFractionDigits: 0});

export function short(value) {
  if (!Number.isFinite(value)) return '–';
  if (Number.isInteger(value) && Math.abs(value) < 1e9) return whole.format(value);
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) return value.toExponential(2).replace('e+', 'e');
  return String(Number(value.toPrecision(3)));
}

// Returns the index of the last number that is at most `value`, or 0 if there is none. `numbers`
// are ascending.
export function lastNotAbove(numbers, value) {
  let low = 0, high = numbers.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (numbers[middle] <= value) low = middle + 1; else high = middle;
  }
  return Math.max(low - 1, 0);
}

// Returns the step that is shown together with `number`: the first step with at least this number,
// or else the last step. `steps` are sorted by number.
export function shownWith(steps, number) {
  return steps.find((step) => step.number >= number) ?? steps.at(-1);
}

export function nearest(numbers, value) {
  const before = lastNotAbove(numbers, value);
  const after = Math.min(before + 1, numbers.length - 1);
  return value - numbers[before] <= numbers[after] - value ? before : after;
}
