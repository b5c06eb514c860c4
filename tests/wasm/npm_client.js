// SPDX-License-Identifier: BSD-2-Clause
// A client of a Soar kernel, as users of the npm package write it. run_npm.py runs it: node npm_client.js PORT
'use strict';

const assert = require('node:assert/strict');
const {writeFileSync} = require('node:fs');
const {Kernel} = require('soarbox');

const RULES = `sp {add
   (state <s> ^superstate nil ^io <io>)
   (<io> ^input-link.pair <p> ^output-link <o>)
   (<p> ^a <a> ^b <b> ^name <name>)
-->
   (<o> ^sum <c>)
   (<c> ^value (+ <a> <b>) ^twice (exec double <a>) ^name <name>)
   (write |adding <&> for | <name>)}
`;

/** Puts two numbers on the input link and expects a command with their sum. */
async function addsNumbers(kernel, agent) {
  const printed = [], handled = [], fired = [], cycles = [];
  await agent.RegisterForPrintEvent((_, text) => void printed.push(text));
  await agent.RegisterForProductionEvent('after-production-fired', (_, rule) => void fired.push(rule));
  // A handler may call the kernel, which waits for the handler.
  const number = await agent.RegisterForRunEvent('after-decision-cycle', async () => void cycles.push(await agent.ExecuteCommandLine('print i2')));
  agent.AddOutputHandler('sum', (given, attribute, wme) => void handled.push([given, attribute, wme.GetParameterValue('value')]));
  await kernel.AddRhsFunction('double', (given, name, argument) => {
    assert.deepEqual([given, name], [agent, 'double']);
    return String(2 * Number(argument));
  });
  writeFileSync('add.soar', RULES);
  assert.match(await agent.LoadProductions('add.soar'), /1 production sourced/);

  const pair = (await agent.GetInputLink()).CreateIdWME('pair'), a = pair.CreateIntWME('a', 3);
  pair.CreateFloatWME('b', 0.5);
  pair.CreateStringWME('name', 'Ä & <x>');
  assert.equal(agent.IsCommitRequired(), true);
  await agent.RunSelfTilOutput();
  assert.equal(agent.GetNumberCommands(), 1);
  const command = agent.GetCommand(0);
  assert.deepEqual(['value', 'twice', 'name', 'none'].map((name) => command.GetParameterValue(name)), ['3.5', '6', 'Ä & <x>', null]);
  assert.deepEqual([command.GetCommandName(), command.FindByAttribute('value').GetValue(), command.FindByAttribute('value').GetValueType()], ['sum', 3.5, 'double']);
  assert.deepEqual(handled, [[agent, 'sum', '3.5']]);
  assert.match(printed.join(''), /adding <&> for Ä & <x>/);
  assert.deepEqual(fired, ['add']);
  assert.match(cycles[0], /\^pair/);
  assert.equal(kernel.UnregisterForEvent(number), true);
  assert.equal(kernel.UnregisterForEvent(number), false);
  const seen = cycles.length;

  command.AddStatusComplete();
  await agent.RunSelf(1);
  assert.equal(agent.GetNumberCommands(), 0);
  assert.match(await agent.ExecuteCommandLine('print --depth 3 i3'), /\^status complete/);

  a.Update(10);
  await agent.RunSelf(3);
  assert.equal(agent.GetNumberCommands(), 1);
  assert.equal(agent.GetCommand(0).GetParameterValue('value'), '10.5');
  assert.equal(agent.GetOutputLink().GetNumberChildren(), 1);
  assert.equal(cycles.length, seen);

  // init-soar adds the input again.
  await agent.InitSoar();
  await agent.RunSelfTilOutput();
  assert.equal(agent.GetCommand(0).GetParameterValue('value'), '10.5');
  pair.DestroyWME();
  await agent.RunSelf(3);
  assert.equal(agent.GetOutputLink().GetNumberChildren(), 0);
  assert.throws(() => pair.DestroyWME(), /removed already/);
}

/** Each error has a message. */
async function refuses(kernel, agent) {
  assert.match(await agent.ExecuteCommandLine('nonsense'), /No such command: nonsense/);
  assert.equal(kernel.GetLastCommandLineResult(), false);
  assert.match(await agent.ExecuteCommandLine('print s1'), /S1/);
  assert.equal(kernel.GetLastCommandLineResult(), true);
  await assert.rejects(agent.LoadProductions('/nowhere.soar'), /nowhere\.soar/);
  await assert.rejects(kernel.CreateAgent('adder'), /there is an agent 'adder' already/);
  await assert.rejects(agent.RegisterForRunEvent('after-lunch', () => undefined), /'after-lunch'/);
  await assert.rejects(agent.RunSelf(0), /at least one step/);
  await assert.rejects(agent.RunSelf(1, 'day'), /no unit 'day'/);
  const link = await agent.GetInputLink();
  assert.throws(() => link.CreateIntWME('n', 1.5), /an integer is expected, not 1\.5/);
  assert.throws(() => link.CreateStringWME('n', 1), /a string is expected, not 1/);
  assert.throws(() => link.CreateFloatWME('n', NaN), /a finite number is expected/);
  assert.throws(() => link.CreateStringWME('', 'x'), /at least one letter/);
  await assert.rejects(Kernel.CreateRemoteConnection('127.0.0.1', 1), /no kernel at 127\.0\.0\.1:1 .*soarbox kernel starts one/);
}

async function hasAgents(kernel, agent) {
  const made = [];
  await kernel.RegisterForAgentEvent('after-agent-created', (_, name) => void made.push(name));
  const other = await kernel.CreateAgent('other');
  assert.deepEqual((await kernel.GetAgents()).map((each) => each.GetAgentName()), ['adder', 'other']);
  assert.equal(await kernel.GetAgent('other'), other);
  await kernel.RunAllAgents(2);
  // Both links of an identifier show the same elements.
  const link = await other.GetInputLink(), first = link.CreateIdWME('left');
  first.CreateIntWME('big', 2n ** 60n);
  const second = link.CreateSharedIdWME('right', first);
  assert.equal(second.GetChild(0), first.GetChild(0));
  assert.match(await other.ExecuteCommandLine('run 1'), /decision/);
  assert.match(await other.ExecuteCommandLine('print --depth 2 i2'), /\^big 1152921504606846976/);
  await kernel.RegisterForClientMessageEvent('greet', (given, name, message) => `hello ${message}`);
  assert.equal(await kernel.SendClientMessage(agent, 'greet', 'you'), 'hello you');
  await kernel.DestroyAgent(other);
  assert.equal(await kernel.GetAgent('other'), null);
  assert.deepEqual(made, ['other']);
}

async function main(port) {
  const kernel = await Kernel.CreateRemoteConnection('127.0.0.1', port);
  assert.match(await kernel.GetSoarKernelVersion(), /^\d+\.\d+\.\d+$/);
  const agent = await kernel.CreateAgent('adder');
  await addsNumbers(kernel, agent);
  await refuses(kernel, agent);
  await hasAgents(kernel, agent);
  kernel.Shutdown();
  await assert.rejects(kernel.GetAgents(), /shut down by this program/);
  console.log('all checks passed');
}

main(Number(process.argv[2]));
