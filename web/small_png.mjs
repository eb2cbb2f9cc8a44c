// A screenshot with 256 colours at most: a third of its bytes, and the text as sharp as before.
//
//     await writeFile(path, smallPng(await page.screenshot()));
import { deflateSync, inflateSync } from 'node:zlib';

const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);

/**
 * Eight bits a channel, three or four channels, not interlaced: what browsers write. Alpha is left
 * out.
 */
function pixelsOf(png) {
  const data = [];
  let [width, height, channels] = [0, 0, 3];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    const name = png.toString('latin1', at + 4, at + 8);
    const body = png.subarray(at + 8, at + 8 + png.readUInt32BE(at));
    if (name === 'IHDR') {
      [width, height, channels] = [
        body.readUInt32BE(0),
        body.readUInt32BE(4),
        body[9] === 6 ? 4 : 3,
      ];
    } else if (name === 'IDAT') {
      data.push(body);
    }
  }
  const raw = inflateSync(Buffer.concat(data));
  const long = width * channels;
  const pixels = new Uint32Array(width * height);
  let above = new Uint8Array(long);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (long + 1)];
    const row = raw.subarray(y * (long + 1) + 1, (y + 1) * (long + 1));
    for (let i = 0; i < long; ++i) {
      const [a, b, c] = [
        i < channels ? 0 : row[i - channels],
        above[i],
        i < channels ? 0 : above[i - channels],
      ];
      const p = a + b - c;
      const nearest =
        Math.abs(p - a) <= Math.abs(p - b) && Math.abs(p - a) <= Math.abs(p - c)
          ? a
          : Math.abs(p - b) <= Math.abs(p - c)
            ? b
            : c;
      row[i] = (row[i] + [0, a, b, (a + b) >> 1, nearest][filter]) & 255;
    }
    for (let x = 0; x < width; ++x) {
      pixels[y * width + x] =
        (row[x * channels] << 16) | (row[x * channels + 1] << 8) | row[x * channels + 2];
    }
    above = row;
  }
  return { width, height, pixels };
}

const table = Uint32Array.from({ length: 256 }, (_, n) =>
  Array.from({ length: 8 }).reduce((c) => (c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1), n),
);
const crc32 = (bytes) => ~bytes.reduce((c, byte) => table[(c ^ byte) & 255] ^ (c >>> 8), -1) >>> 0;

function chunk(name, body) {
  const named = Buffer.concat([Buffer.from(name, 'latin1'), body]);
  const ends = Buffer.alloc(8);
  ends.writeUInt32BE(body.length, 0);
  ends.writeUInt32BE(crc32(named), 4);
  return Buffer.concat([ends.subarray(0, 4), named, ends.subarray(4)]);
}

export function smallPng(png) {
  const { width, height, pixels } = pixelsOf(png);
  const counts = new Map();
  pixels.forEach((colour) => counts.set(colour, (counts.get(colour) ?? 0) + 1));
  // Of colours that look alike the most frequent is kept.
  const chosen = new Map();
  const often = [...counts]
    .sort((one, other) => other[1] - one[1] || one[0] - other[0])
    .map(([colour]) => colour);
  for (const colour of often) {
    const alike = counts.size <= 256 ? colour : colour & 0xf8f8f8;
    if (!chosen.has(alike) && chosen.size < 256) {
      chosen.set(alike, colour);
    }
  }
  const palette = [...chosen.values()];
  const far = (one, other) =>
    [16, 8, 0].reduce(
      (sum, shift) => sum + (((one >> shift) & 255) - ((other >> shift) & 255)) ** 2,
      0,
    );
  const place = new Map(
    often.map((colour) => [
      colour,
      palette.reduce(
        (best, each, i) => (far(each, colour) < far(palette[best], colour) ? i : best),
        0,
      ),
    ]),
  );
  const rows = Buffer.alloc((width + 1) * height);
  pixels.forEach((colour, i) => (rows[i + Math.floor(i / width) + 1] = place.get(colour)));
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 3], 8);
  const colours = Buffer.from(
    palette.flatMap((colour) => [colour >> 16, (colour >> 8) & 255, colour & 255]),
  );
  return Buffer.concat([
    signature,
    chunk('IHDR', head),
    chunk('PLTE', colours),
    chunk('IDAT', deflateSync(rows, { level: 9 })),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}
