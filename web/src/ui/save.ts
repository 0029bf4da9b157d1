/** Hands files to the reader. */
export function download(name: string, blob: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser reads it after the click has been dealt with.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export function saveSvg(name: string, markup: string): void {
  download(`${name}.svg`, new Blob([markup], { type: 'image/svg+xml' }));
}

export function saveCsv(name: string, text: string): void {
  download(`${name}.csv`, new Blob([text], { type: 'text/csv' }));
}

/** At twice the size of the screen, sharp enough for slides and paper. */
export async function savePng(name: string, markup: string): Promise<void> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(markup)}`;
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = 2 * image.width;
  canvas.height = 2 * image.height;
  canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
  saveCanvas(name, canvas);
}

export function saveCanvas(name: string, canvas: HTMLCanvasElement): void {
  canvas.toBlob((blob) => {
    if (blob) download(`${name}.png`, blob);
  }, 'image/png');
}

/** A name that every file system takes. */
export function fileName(...parts: string[]): string {
  return parts
    .join('-')
    .replaceAll(', ', '-')
    .replaceAll('−', '-')
    .replace(/[^\p{L}\p{N}+._-]+/gu, '_');
}
