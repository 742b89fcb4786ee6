// The laboratory as one file, for notebooks: `littlewood/lab/laboratory.js` of the Python package, a
// module for anywidget.

import { readFileSync, renameSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const place = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** Everything is in the document: it may run its own text, and ask for nothing. */
const POLICY =
  "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:; connect-src data:; worker-src blob:; base-uri 'none'; form-action 'none'";

/** Puts script and styles into the page, and the page into the module of the widget. */
function oneFile(): Plugin {
  return {
    name: 'one-file',
    apply: 'build',
    enforce: 'post',
    generateBundle(_, bundle) {
      let script = '';
      let style = '';
      let page = '';
      for (const [name, file] of Object.entries(bundle)) {
        if (file.type === 'chunk') script += file.code;
        else if (name.endsWith('.css')) style += String(file.source);
        else if (name.endsWith('.html')) page = String(file.source);
        delete bundle[name];
      }
      // A closing tag within a text of the script would end it.
      const safe = script.replaceAll('</script', '<\\/script');
      page = page
        .replace(/<script type="module"[^>]*><\/script>/, '')
        .replace(/<link rel="(stylesheet|icon|manifest|modulepreload)"[^>]*>/g, '')
        .replace(
          /(http-equiv="Content-Security-Policy" content=")[^"]*/,
          (_, head: string) => head + POLICY,
        )
        // There is no other page beside a notebook.
        .replace(/<a href="\.\/story\.html"[^>]*><\/a>\. /, '')
        .replace('</head>', () => `<style>${style}</style></head>`)
        .replace('</body>', () => `<script type="module">${safe}</script></body>`);
      const widget = readFileSync(place('./notebook/widget.js'), 'utf8');
      const text = widget.replace("'PAGE'", () => JSON.stringify(page));
      // All of it at once: a wheel may be made meanwhile.
      const module = place('../python/littlewood/lab/laboratory.js');
      writeFileSync(`${module}.part`, text);
      renameSync(`${module}.part`, module);
      this.info(`python/littlewood/lab/laboratory.js ${(text.length / 1000).toFixed(0)} kB`);
    },
  };
}

export default defineConfig({
  base: './',
  resolve: { alias: [{ find: './spawn', replacement: place('./src/map/spawn-inline.ts') }] },
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist-notebook',
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    cssCodeSplit: false,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    rolldownOptions: { output: { codeSplitting: false } },
  },
  worker: { format: 'es' },
  plugins: [oneFile()],
});
