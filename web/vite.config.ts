import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

// One page at a time, `--mode report` or `--mode designer`: each is one file.
export default defineConfig(({ mode }) => ({
  plugins: [viteSingleFile()],
  build: {
    target: 'es2021',
    chunkSizeWarningLimit: 2000,
    emptyOutDir: false,
    rollupOptions: { input: mode === 'designer' ? 'designer.html' : 'index.html' },
  },
}));
