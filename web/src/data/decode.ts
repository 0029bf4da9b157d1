/** Reads the base64 that the page's data is written in. */

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** Numbers of little-endian binary32, as every machine with a browser has them; NaN where one is absent. */
export function decodeNumbers(base64: string): Float32Array {
  return new Float32Array(bytesOf(base64).buffer);
}

/** Signed bytes; -127 where a flag is absent. */
export function decodeFlags(base64: string): Int8Array {
  return new Int8Array(bytesOf(base64).buffer);
}
