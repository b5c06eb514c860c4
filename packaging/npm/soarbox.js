#!/usr/bin/env node
// SPDX-License-Identifier: BSD-2-Clause
// The soarbox command as WebAssembly. It runs in a Node.js process of its own, because a larger stack can be given only at its start.
'use strict';

const {spawn} = require('node:child_process');
const {existsSync} = require('node:fs');
const {join} = require('node:path');

/** The kB of stack that minds and scripts may use: below the limit that the system usually sets, which is lower on Windows. */
const STACK_KB = process.platform === 'win32' ? 900 : 6000;
const CANNOT = 3;
const ENGINE = join(__dirname, 'engine', 'soarbox.js');

function runEngine(words) {
  if (!existsSync(ENGINE)) {
    console.error(`soarbox: error: ${ENGINE} is missing: install the package again`);
    process.exit(CANNOT);
  }
  const child = spawn(process.execPath, [`--stack-size=${STACK_KB}`, ENGINE, ...words], {stdio: 'inherit'});
  // Ctrl+C reaches both processes; the engine decides how it ends.
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => child.kill(signal));
  child.on('error', (problem) => {
    console.error(`soarbox: error: Node.js does not start: ${problem.message}`);
    process.exit(CANNOT);
  });
  child.on('exit', (code, signal) => {
    if (signal === null) process.exit(code);
    process.removeAllListeners(signal);
    process.kill(process.pid, signal);
  });
}

const words = process.argv.slice(2);
if (words[0] === 'serve') require('./serve').serve(words.slice(1));
else runEngine(words);
