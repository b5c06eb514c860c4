// SPDX-License-Identifier: BSD-2-Clause
// Runs worlds and commands from JavaScript, as users of the npm package do. run_npm.py runs it.
'use strict';

const assert = require('node:assert/strict');
const {runCommand, runWorld} = require('soarbox');

async function stateAfter(options) {
  const events = [];
  for await (const event of runWorld('soar_flee', options)) events.push(event);
  const end = events.at(-1);
  assert.equal(end.event, 'end');
  assert.ok(events.length > 1);
  return end.state;
}

async function main() {
  const first = await stateAfter({seconds: 3});
  assert.match(first, /^[\da-f]{16}$/);
  assert.equal(await stateAfter({seconds: 3}), first);
  assert.notEqual(await stateAfter({seconds: 4}), first);
  await assert.rejects(stateAfter({seconds: -1}), /seconds/);
  await assert.rejects(async () => { for await (const event of runWorld('no_such_world')) assert.fail(event.event); }, /no_such_world/);
  // Leaving the loop ends the run, which would otherwise last for a million seconds.
  for await (const event of runWorld('soar_flee', {seconds: 1e6})) {
    assert.ok(event.event);
    break;
  }
  const soar = await runCommand(['soar'], {input: 'print s1\nexit\n'});
  assert.equal(soar.code, 0);
  assert.match(soar.stdout, /\^superstate nil/);
  const wrong = await runCommand(['chek']);
  assert.equal(wrong.code, 2);
  assert.match(wrong.stderr, /check/);
  console.log('all checks passed');
}

main();
