// SPDX-License-Identifier: BSD-2-Clause
// Worlds and commands from JavaScript: the program in this package, in a process of its own.
'use strict';

const {spawn} = require('node:child_process');
const {join} = require('node:path');
const {createInterface} = require('node:readline');

const PROGRAM = join(__dirname, 'soarbox.js');

function start(words, options) {
  return spawn(process.execPath, [PROGRAM, ...words.map(String)], {cwd: options.cwd, env: options.env ?? process.env});
}

/** All of a stream, as text. */
async function textOf(stream) {
  const parts = [];
  for await (const part of stream) parts.push(part);
  return Buffer.concat(parts).toString('utf8');
}

/** Runs `soarbox WORDS...` and resolves with what it printed. */
async function runCommand(words, options = {}) {
  const child = start(words, options);
  child.stdin.on('error', () => undefined);
  child.stdin.end(options.input ?? '');
  const ended = new Promise((done, failed) => child.on('error', failed).on('close', done));
  const [stdout, stderr, code] = await Promise.all([textOf(child.stdout), textOf(child.stderr), ended]);
  return {code, stdout, stderr};
}

/** The events of a run without a window, as they happen. Leaving the loop ends the run. */
async function* runWorld(world, options = {}) {
  const words = ['run', world, '--headless', '--json'];
  for (const [name, value] of Object.entries({'--seconds': options.seconds, '--seed': options.seed, '--record': options.record}))
    if (value !== undefined) words.push(name, value);
  const child = start(words, options);
  child.stdin.end();
  const ended = new Promise((done, failed) => child.on('error', failed).on('close', done));
  const problems = textOf(child.stderr).catch(() => '');
  let events = 0;
  try {
    for await (const line of createInterface({input: child.stdout})) {
      if (!line.startsWith('{')) continue;
      events += 1;
      yield JSON.parse(line);
    }
  } finally {
    child.kill();
    child.stdout.destroy();
  }
  const code = await ended;
  if (code !== 0 && events === 0) throw new Error((await problems).trim() || `soarbox run ended with ${code}`);
}

module.exports = {runCommand, runWorld};
