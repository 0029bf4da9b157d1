/** Reads the base64 that the page's data is written in. */

function bytesOf(base64: string): Uint8Array {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** Numbers of little-endian binary32; NaN where one is absent. */
export function decodeNumbers(base64: string): Float32Array {
  const bytes = bytesOf(base64);
  const view = new DataView(bytes.buffer);
  const numbers = new Float32Array(bytes.length / 4);
  for (let i = 0; i < numbers.length; i += 1) numbers[i] = view.getFloat32(4 * i, true);
  return numbers;
}

/** Signed bytes; -127 where a flag is absent. */
export function decodeFlags(base64: string): Int8Array {
  return new Int8Array(bytesOf(base64).buffer);
}
