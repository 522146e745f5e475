import { gzipSync } from 'node:zlib';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { defineConfig } from 'vitest/config';

// `npm run dev` serves the page with live reload against a program on 8080 (or PLAYHOUSE_WEB=host:port). The proxy leaves
// Host and Origin as the browser sent them, both localhost:5173, so that the program takes the page for its own.
const program = process.env.PLAYHOUSE_WEB ?? '127.0.0.1:8080';

/** Leaves FILE.gz beside each built file; the program serves it to browsers that take it. */
function compress(): Plugin {
  return {
    name: 'compress',
    apply: 'build',
    closeBundle() {
      for (const entry of readdirSync('dist', { recursive: true, withFileTypes: true })) {
        if (!entry.isFile() || entry.name.endsWith('.gz')) continue;
        const path = join(entry.parentPath ?? entry.path, entry.name);
        writeFileSync(`${path}.gz`, gzipSync(readFileSync(path), { level: 9 }));
      }
    },
  };
}

export default defineConfig({
  base: './',
  plugins: [compress()],
  server: { proxy: { '/live': { target: `ws://${program}`, ws: true }, '/meshes': { target: `http://${program}` }, '/player': { target: `ws://${program}`, ws: true }, '/status.json': { target: `http://${program}` } } },
  build: { target: 'es2022', chunkSizeWarningLimit: 1500, rollupOptions: { input: ['index.html', 'devices.html'] } },
  test: { include: ['src/**/*.test.ts'] },
});
