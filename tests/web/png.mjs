// PNG files as Chromium writes them: 8 bits, with or without opacity, not interlaced.
import assert from 'node:assert/strict';
import zlib from 'node:zlib';

/** A picture as { width, height, data } with four bytes a pixel. */
export function decoded(png) {
  const width = png.readUInt32BE(16);
  const height = png.readUInt32BE(20);
  const channels = { 2: 3, 6: 4 }[png[25]];
  assert.ok(png[24] === 8 && channels && png[28] === 0, 'a PNG of another kind');
  const parts = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
    if (png.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  const rows = zlib.inflateSync(Buffer.concat(parts));
  const stride = width * channels;
  const data = Buffer.alloc(4 * width * height, 255);
  let above = new Uint8Array(stride);
  for (let y = 0; y < height; ++y) {
    const row = rows.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1));
    undo(rows[y * (stride + 1)], row, above, channels);
    for (let x = 0; x < width; ++x) for (let c = 0; c < channels; ++c) data[4 * (y * width + x) + c] = row[channels * x + c];
    above = row;
  }
  return { width, height, data };
}

/** A row is stored as its difference to what `filter` foretells. */
function undo(filter, row, above, channels) {
  for (let i = filter === 0 ? row.length : 0; i < row.length; ++i) {
    const left = i >= channels ? row[i - channels] : 0;
    const corner = i >= channels ? above[i - channels] : 0;
    if (filter === 1) row[i] += left;
    else if (filter === 2) row[i] += above[i];
    else if (filter === 3) row[i] += (left + above[i]) >> 1;
    else {
      const guess = left + above[i] - corner;
      const [toLeft, toAbove, toCorner] = [Math.abs(guess - left), Math.abs(guess - above[i]), Math.abs(guess - corner)];
      row[i] += toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above[i] : corner;
    }
  }
}

export function cropped({ width, data }, box) {
  const [left, top, columns, rows] = [box.x, box.y, box.width, box.height].map(Math.round);
  const part = Buffer.alloc(4 * columns * rows);
  for (let y = 0; y < rows; ++y) data.copy(part, 4 * y * columns, 4 * ((top + y) * width + left), 4 * ((top + y) * width + left + columns));
  return { width: columns, height: rows, data: part };
}
