// SPDX-License-Identifier: BSD-2-Clause
// `soarbox serve` for one user: it sends the files of the site, in which agents run in the browser (docs/site.md).
'use strict';

const {createReadStream, existsSync, realpathSync, statSync} = require('node:fs');
const {createServer} = require('node:http');
const {extname, join, sep} = require('node:path');

const SITE = join(__dirname, 'site');
const BAD_COMMAND = 2, CANNOT = 3;
const TYPES = {
  '.css': 'text/css; charset=utf-8', '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.json': 'application/json',
  '.png': 'image/png', '.svg': 'image/svg+xml', '.txt': 'text/plain; charset=utf-8', '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json', '.webp': 'image/webp', '.woff2': 'font/woff2',
};
const HELP = `Serve lessons and worlds to a browser on this machine
Usage: soarbox serve [OPTIONS]

Options:
  -h,--help                   Print this help message and exit
  --listen ADDRESS:PORT=127.0.0.1:8080
                              Address and port: 127.0.0.1, localhost or [::1]; port 0: any free one

The agents run in the browser, which also keeps your files. Classes and other options need the native program.
`;

function fail(code, message, hint) {
  console.error(`soarbox: error: ${message}\n   hint: ${hint}`);
  process.exit(code);
}

/** The host and port to listen at. */
function readOptions(words) {
  let place = '127.0.0.1:8080';
  const rest = [...words];
  while (rest.length > 0) {
    const [name, ...values] = rest.shift().split('=');
    if (name === '-h' || name === '--help') {
      process.stdout.write(HELP);
      process.exit(0);
    }
    if (name !== '--listen') fail(BAD_COMMAND, `serve does not take '${name}' here`, 'soarbox serve --help lists its options; the native program has more');
    place = values.length > 0 ? values.join('=') : rest.shift() ?? '';
  }
  const parts = /^(127\.0\.0\.1|localhost|\[::1\]):(\d{1,5})$/.exec(place);
  if (parts === null || Number(parts[2]) > 65535)
    fail(BAD_COMMAND, `--listen ${place}: expected an address of this machine and a port`, 'for example --listen 127.0.0.1:8080');
  return {host: parts[1], port: Number(parts[2])};
}

/** The file of the site that a request means, or null. Files outside of the site are never sent. */
function fileFor(url) {
  let path;
  try {
    path = decodeURIComponent(url.split(/[?#]/)[0]);
  } catch {
    return null;
  }
  if (path.includes('\0')) return null;
  const file = join(SITE, path.endsWith('/') ? `${path}index.html` : path);
  if (!existsSync(file) || !statSync(file).isFile()) return null;
  return realpathSync(file).startsWith(realpathSync(SITE) + sep) ? file : null;
}

function answer(request, response) {
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.writeHead(405, {'Content-Type': 'text/plain', Allow: 'GET, HEAD'}).end('only GET and HEAD\n');
    return;
  }
  const file = fileFor(request.url);
  if (file === null) {
    response.writeHead(404, {'Content-Type': 'text/plain'}).end('there is no such file\n');
    return;
  }
  response.writeHead(200, {
    'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream', 'Content-Length': statSync(file).size,
    'Cache-Control': 'no-cache', 'X-Content-Type-Options': 'nosniff',
  });
  if (request.method === 'HEAD') response.end();
  else createReadStream(file).on('error', () => response.destroy()).pipe(response);
}

function serve(words) {
  const {host, port} = readOptions(words);
  if (!existsSync(join(SITE, 'index.html'))) fail(CANNOT, `${SITE} is missing`, 'install the package again');
  const server = createServer(answer);
  server.on('error', (problem) => fail(CANNOT, `cannot listen at ${host}:${port}: ${problem.code}`, 'another program may use this port: choose another with --listen'));
  server.listen(port, host.replace(/[[\]]/g, ''), () => console.log(`soarbox: serving http://${host}:${server.address().port}/ until Ctrl+C`));
}

module.exports = {serve};
