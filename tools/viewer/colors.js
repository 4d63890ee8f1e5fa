// Maps numbers to colors by the tables in the page. Colors of vertices are squared sRGB values
// (materials.js); colors of the legend are CSS.

const gray = [0.25, 0.25, 0.25];
const lightOf = (byte) => (byte / 255) ** 2;

// Returns the ends of a color scale. If both signs occur, the scale is symmetric around 0.
export function scaleOf(low, high) {
  if (!(low < 0 && high > 0)) return {low, high, isDiverging: false};
  const end = Math.max(-low, high);
  return {low: -end, high: end, isDiverging: true};
}

export class Colors {
  constructor(tables) {
    this.tables = tables;
  }

  table(scale) {
    return scale.isDiverging ? this.tables.two_signs : this.tables.one_sign;
  }

  gradient(scale) {
    return `linear-gradient(to right, ${this.table(scale).map((c) => `rgb(${c.join(' ')})`).join(', ')})`;
  }

  // Returns three color channels for each value.
  light(values, scale) {
    const table = this.#lights(scale);
    const last = table.length / 3 - 1;
    const factor = scale.high > scale.low ? last / (scale.high - scale.low) : 0;
    const light = new Float32Array(3 * values.length);
    for (let i = 0; i < values.length; ++i) {
      const code = Math.round(Math.min(Math.max((values[i] - scale.low) * factor, 0), last));
      for (let c = 0; c < 3; ++c)
        light[3 * i + c] = Number.isNaN(code) ? gray[c] : table[3 * code + c];
    }
    return light;
  }

  // Returns a finer table of squared sRGB values, with 16 steps between two colors.
  #lights(scale) {
    const colors = this.table(scale);
    const fine = new Float32Array(3 * (16 * (colors.length - 1) + 1));
    for (let i = 0; i < fine.length / 3; ++i) {
      const before = Math.min(i >> 4, colors.length - 2);
      const share = i / 16 - before;
      for (let c = 0; c < 3; ++c)
        fine[3 * i + c] = lightOf((1 - share) * colors[before][c] + share * colors[before + 1][c]);
    }
    return fine;
  }
}

export function lightOfChannels(channels) {
  const light = new Float32Array(3 * channels[0].length);
  channels.forEach((channel, c) => {
    for (let i = 0; i < channel.length; ++i) light[3 * i + c] = lightOf(channel[i]);
  });
  return light;
}
