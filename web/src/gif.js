/**
 * Animated GIF (version 89a): frames of one size with one palette of 255 colours, found by median cut. Pixels that do not
 * change from frame to frame are transparent, so that a structure before an unchanging ground takes few bytes.
 */

const CLEAR = 255; // index of the transparent colour
const MOST_CODES = 4096;
const BLOCK = 255; // bytes of a block
const SHADES = 32; // steps of a colour's channel for the palette

/** Collect frames, which are RGBA with full opacity; `bytes` returns the file, which repeats for ever. */
export function makeGif(width, height, seconds) {
  const frames = [];
  return {
    add: (pixels) => frames.push(coarse(pixels)),
    bytes: () => encode(frames, width, height, Math.round(100 * seconds)),
  };
}

/** Colours of 15 bits. */
function coarse(pixels) {
  const indices = new Uint16Array(pixels.length / 4);
  for (let at = 0; at < indices.length; at++) indices[at] = ((pixels[4 * at] >> 3) << 10) | ((pixels[4 * at + 1] >> 3) << 5) | (pixels[4 * at + 2] >> 3);
  return indices;
}

function encode(frames, width, height, hundredths) {
  const { palette, indexOf } = paletteOf(frames);
  const out = [];
  const short = (value) => out.push(value & 255, value >> 8);
  out.push(...new TextEncoder().encode("GIF89a"));
  short(width);
  short(height);
  // a table of 256 colours, no background, square pixels
  out.push(0xf7, 0, 0, ...palette);
  out.push(0x21, 0xff, 11, ...new TextEncoder().encode("NETSCAPE2.0"), 3, 1, 0, 0, 0);
  let before = null;
  for (const frame of frames) {
    const indices = Uint8Array.from(frame, (colour, at) => (before && before[at] === colour ? CLEAR : indexOf[colour]));
    // do not clear the previous frame under transparent pixels
    out.push(0x21, 0xf9, 4, 0x05);
    short(hundredths);
    out.push(CLEAR, 0, 0x2c);
    for (const value of [0, 0, width, height]) short(value);
    out.push(0, 8);
    const codes = compressed(indices);
    for (let at = 0; at < codes.length; at += BLOCK) {
      const end = Math.min(at + BLOCK, codes.length);
      out.push(end - at);
      for (let place = at; place < end; place++) out.push(codes[place]);
    }
    out.push(0);
    before = frame;
  }
  out.push(0x3b);
  return Uint8Array.from(out);
}

/** Bytes of the indices by variable-length codes (Lempel, Ziv and Welch). */
function compressed(indices) {
  const out = [];
  let [bits, count] = [0, 0];
  let size = 9;
  let next = 258;
  let known = new Int32Array(MOST_CODES << 8).fill(-1);
  const put = (code) => {
    bits |= code << count;
    count += size;
    while (count >= 8) {
      out.push(bits & 255);
      bits >>>= 8;
      count -= 8;
    }
  };
  put(256);
  let prefix = indices[0];
  for (let at = 1; at < indices.length; at++) {
    const key = (prefix << 8) | indices[at];
    if (known[key] >= 0) {
      prefix = known[key];
      continue;
    }
    put(prefix);
    if (next < MOST_CODES) {
      known[key] = next;
      if (next === 1 << size && size < 12) size++;
      next++;
    } else {
      put(256);
      known.fill(-1);
      [size, next] = [9, 258];
    }
    prefix = indices[at];
  }
  put(prefix);
  put(257);
  if (count) out.push(bits & 255);
  return out;
}

/** 255 colours by median cut, as bytes, and the index of each colour of 15 bits. */
function paletteOf(frames) {
  const counts = new Uint32Array(SHADES ** 3);
  for (const frame of frames) for (let at = 0; at < frame.length; at++) counts[frame[at]]++;
  const used = [...counts.keys()].filter((colour) => counts[colour]);
  const boxes = [boxOf(used, counts)];
  while (boxes.length < CLEAR) {
    // cut the box whose spread of colours, weighted by its pixels, is the largest
    const box = boxes.reduce((most, each) => (each.spread > most.spread ? each : most));
    if (!box.spread) break;
    const sorted = box.colours.sort((one, other) => channelsOf(one)[box.channel] - channelsOf(other)[box.channel]);
    const half = sorted.length >> 1;
    boxes.splice(boxes.indexOf(box), 1, boxOf(sorted.slice(0, half), counts), boxOf(sorted.slice(half), counts));
  }
  const palette = new Uint8Array(3 * 256);
  const indexOf = new Uint8Array(SHADES ** 3);
  for (const [index, { colours, weight }] of boxes.entries()) {
    for (let each = 0; each < 3; each++) {
      const mean = colours.reduce((sum, colour) => sum + counts[colour] * channelsOf(colour)[each], 0) / weight;
      palette[3 * index + each] = Math.round((mean * 255) / (SHADES - 1));
    }
    for (const colour of colours) indexOf[colour] = index;
  }
  return { palette, indexOf };
}

const channelsOf = (colour) => [colour >> 10, (colour >> 5) & 31, colour & 31];

/** Colours with their number of pixels, their widest channel, and the weight of this width. */
function boxOf(colours, counts) {
  const weight = colours.reduce((sum, colour) => sum + counts[colour], 0);
  const widths = [0, 1, 2].map((each) => {
    const values = colours.map((colour) => channelsOf(colour)[each]);
    return values.reduce((most, value) => Math.max(most, value)) - values.reduce((least, value) => Math.min(least, value));
  });
  const width = Math.max(...widths);
  return { colours, weight, channel: widths.indexOf(width), spread: width * width * Math.sqrt(weight) };
}
