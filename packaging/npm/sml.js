// SPDX-License-Identifier: BSD-2-Clause
// A client of Soar kernels, with the names of Soar's own client library (sml.d.ts describes it, docs/npm.md shows it).
'use strict';

const {resolve} = require('node:path');
const {Identifier, Memory, WMElement} = require('./sml_memory');
const {Element, SocketLink, newDocument, readXml} = require('./sml_wire');

const DEFAULT_PORT = 12121;
/** How `run` calls the units of a run. */
const STEPS = {phase: 'p', elaboration: 'e', decision: 'd', output: 'o'};

function runLine(scope, count, step) {
  if (!(step in STEPS)) throw new TypeError(`a run has no unit '${step}': ${Object.keys(STEPS).join(', ')}`);
  if (!Number.isSafeInteger(count) || count < 1) throw new TypeError(`a run has at least one step, not ${count}`);
  return `run${scope} -${STEPS[step]} ${count}`;
}

const quoted = (file) => `"${file.replace(/(["\\])/g, '\\$1')}"`;

class Agent {
  constructor(kernel, name) {
    this.kernel = kernel;
    this.name = name;
    this.memory = new Memory(() => kernel.takeTag());
    this.isReinitialized = false;
  }
  GetAgentName() {
    return this.name;
  }

  // Commands and runs
  ExecuteCommandLine(line) {
    return this.kernel.ExecuteCommandLine(line, this.name);
  }
  /** Throws with the errors, if the file has any. */
  async LoadProductions(file) {
    const text = await this.ExecuteCommandLine(`source ${quoted(resolve(file))}`);
    if (!this.kernel.lastResult) throw new Error(text.trim());
    return text;
  }
  async run(line) {
    await this.Commit();
    this.memory.added.clear();
    return this.ExecuteCommandLine(line);
  }
  async RunSelf(count, step = 'decision') {
    return this.run(runLine(' --self', count, step));
  }
  async RunSelfTilOutput() {
    return this.run('run --self --output');
  }
  async RunSelfForever() {
    return this.run('run --self');
  }
  /** Ends a run that another call began. */
  StopSelf() {
    return this.ExecuteCommandLine('stop-soar --self');
  }
  InitSoar() {
    return this.ExecuteCommandLine('init-soar');
  }

  // Input
  async GetInputLink() {
    if (this.memory.inputLink === null) {
      const name = await this.kernel.askText('get_input_link', {agent: this.name});
      this.memory.inputLink ??= new Identifier(this.memory, null, 'input-link', name, 0);
    }
    return this.memory.inputLink;
  }
  CreateStringWME(parent, attribute, value) {
    return parent.CreateStringWME(attribute, value);
  }
  CreateIntWME(parent, attribute, value) {
    return parent.CreateIntWME(attribute, value);
  }
  CreateFloatWME(parent, attribute, value) {
    return parent.CreateFloatWME(attribute, value);
  }
  CreateIdWME(parent, attribute) {
    return parent.CreateIdWME(attribute);
  }
  CreateSharedIdWME(parent, attribute, shared) {
    return parent.CreateSharedIdWME(attribute, shared);
  }
  Update(wme, value) {
    wme.Update(value);
  }
  DestroyWME(wme) {
    wme.DestroyWME();
  }
  IsCommitRequired() {
    return this.memory.changes.length > 0;
  }
  async Commit() {
    if (this.isReinitialized) {
      this.isReinitialized = false;
      this.memory.renew(this.memory.inputLink && await this.kernel.askText('get_input_link', {agent: this.name}));
    }
    const changes = this.memory.takeChanges();
    if (changes.length > 0) await this.kernel.ask('input', {agent: this.name}, changes);
  }

  // Output
  GetOutputLink() {
    return this.memory.outputLink;
  }
  commands() {
    return this.memory.newElements().filter((wme) => wme.IsIdentifier());
  }
  Commands() {
    return this.GetNumberCommands() > 0;
  }
  GetNumberCommands() {
    return this.commands().length;
  }
  GetCommand(index) {
    return this.commands()[index] ?? null;
  }

  // Events
  RegisterForPrintEvent(handler) {
    return this.kernel.register('print', this.name, (event) => handler(this, event.arg('message') ?? ''));
  }
  RegisterForRunEvent(event, handler) {
    return this.kernel.register(event, this.name, (given) => handler(this, Number(given.arg('phase'))));
  }
  RegisterForProductionEvent(event, handler) {
    return this.kernel.register(event, this.name, (given) => handler(this, given.arg('name') ?? ''));
  }
  /** `handler` gets each new element of the output link with this attribute. */
  AddOutputHandler(attribute, handler) {
    return this.kernel.addHandler(`output ${this.name}`, (wme) => (wme.attribute === attribute ? handler(this, attribute, wme) : undefined));
  }
}

class Kernel {
  /** Connects to `soarbox kernel`, to a running world, or to Soar's own kernel. */
  static async CreateRemoteConnection(address = '127.0.0.1', port = DEFAULT_PORT) {
    const kernel = new Kernel();
    kernel.link = await SocketLink.open(address, port, (text) => kernel.take(text), (problem) => kernel.end(problem));
    kernel.nextTag = Number(await kernel.askText('initial_time_tag'));
    for (const event of ['after-agent-reinitialized', 'before-agent-destroyed']) await kernel.register(event, undefined, () => undefined);
    return kernel;
  }

  constructor() {
    this.agents = new Map();
    this.handlers = new Map();  // By event, and agent if it has one: a map of handlers by their number.
    this.lastHandler = 0;
    this.lastResult = true;
    this.lastId = 0;
    this.waiting = new Map();
    this.handling = 0;  // Handlers that run now.
    this.nested = 0;  // Calls of theirs that wait for an answer.
    this.queue = Promise.resolve();
    this.ended = null;
  }

  takeTag() {
    const tag = this.nextTag;
    this.nextTag -= 1;
    return tag;
  }

  // Calls of the kernel -------------------------------------------------------------------------------------------------

  /** Resolves with the response. Rejects if it is an error, or if the connection ends. */
  ask(name, args = {}, contents = [], attributes = {}) {
    if (this.ended !== null) return Promise.reject(this.ended);
    const command = new Element('command', {name, ...attributes});
    for (const [arg, value] of Object.entries(args)) if (value !== undefined) command.addArg(arg, value);
    command.children.push(...contents);
    this.lastId += 1;
    const id = String(this.lastId), isNested = this.handling > 0;
    return new Promise((done, failed) => {
      this.waiting.set(id, {done, failed, isNested});
      this.nested += isNested ? 1 : 0;
      this.link.send(newDocument('call', id, [command]));
    });
  }

  async askText(name, args) {
    const response = await this.ask(name, args);
    const error = response.child('error');
    if (error !== undefined) throw new Error(error.text);
    return response.child('result')?.text ?? '';
  }

  take(text) {
    let message;
    try {
      message = readXml(text);
    } catch (problem) {
      this.end(problem);
      this.link.close();
      return;
    }
    const {doctype, ack} = message.attributes;
    const waits = doctype === 'response' ? this.waiting.get(ack) : undefined;
    const finish = () => waits.done(message);
    if (waits !== undefined) {
      this.waiting.delete(ack);
      this.nested -= waits.isNested ? 1 : 0;
      // What the kernel sent before a response is handled before it. A handler itself must not wait for that.
      if (waits.isNested) finish();
      else this.queue = this.queue.then(finish);
    } else if (doctype === 'call') {
      // A handler waits for the kernel, which waits for the answer to this call.
      if (this.nested > 0) void this.answer(message);
      else this.queue = this.queue.then(() => this.answer(message));
    } else if (doctype === 'notify' && message.child('error') !== undefined) {
      this.end(new Error(message.child('error').text));
    }
  }

  end(problem) {
    this.ended ??= problem;
    for (const {failed} of this.waiting.values()) failed(this.ended);
    this.waiting.clear();
  }

  // Calls of the client ---------------------------------------------------------------------------------------------------

  async answer(message) {
    const command = message.child('command');
    const contents = [];
    this.handling += 1;
    try {
      const result = await this.handle(command);
      if (result !== undefined) contents.push(new Element('result', {output: 'raw'}, String(result)));
      for (const agent of this.agents.values()) await agent.Commit();
    } catch (problem) {
      contents.push(new Element('error', {}, problem.message));
      // As of an event handler of Node.js: it ends the program, unless somebody catches it.
      process.nextTick(() => { throw problem; });
    } finally {
      this.handling -= 1;
    }
    this.lastId += 1;
    if (this.ended === null) this.link.send(newDocument('response', String(this.lastId), contents, message.attributes.id));
  }

  async handle(command) {
    const {name} = command.attributes;
    if (name === 'output' || name === 'output_init') return this.handleOutput(command, name);
    if (name !== 'event') throw new Error(`the kernel sent the unknown command '${name}'`);
    const event = command.arg('eventid');
    if (event === 'rhs-user-function' || event === 'client-message') return this.callFunction(event, command);
    const agent = this.agents.get(command.arg('name'));
    if (event === 'after-agent-reinitialized' && agent !== undefined) agent.isReinitialized = true;
    for (const handler of this.handlersOf(event, command.arg('agent'))) await handler(command);
    if (event === 'before-agent-destroyed') this.agents.delete(command.arg('name'));
    return undefined;
  }

  async handleOutput(command, name) {
    const agent = this.agents.get(command.arg('agent'));
    if (agent === undefined) return;
    if (name === 'output_init') {
      agent.memory.forgetOutput();
      return;
    }
    const before = new Set(agent.memory.added);
    agent.memory.receive(command.children.filter((child) => child.tag === 'wme'));
    for (const wme of agent.memory.newElements()) {
      if (before.has(wme)) continue;
      for (const handler of this.handlersOf(`output ${agent.name}`)) await handler(wme);
    }
  }

  async callFunction(event, command) {
    const [handler] = this.handlersOf(event, command.arg('function'));
    return handler?.(this.agents.get(command.arg('name')) ?? null, command.arg('function'), command.arg('value') ?? '');
  }

  // Agents ------------------------------------------------------------------------------------------------------------------

  async adopt(name) {
    if (!this.agents.has(name)) {
      this.agents.set(name, new Agent(this, name));
      await this.ask('register_for_event', {agent: name, eventid: 'output-phase'});
    }
    return this.agents.get(name);
  }
  async agentNames() {
    const response = await this.ask('get_agent_list');
    return (response.child('result')?.children ?? []).map((each) => each.text);
  }
  async CreateAgent(name) {
    if ((await this.agentNames()).includes(name)) throw new Error(`there is an agent '${name}' already`);
    await this.askText('create_agent', {name});
    return this.adopt(name);
  }
  /** Null if there is none of this name. */
  async GetAgent(name) {
    return (await this.agentNames()).includes(name) ? this.adopt(name) : null;
  }
  async GetAgents() {
    const agents = [];
    for (const name of await this.agentNames()) agents.push(await this.adopt(name));
    return agents;
  }
  async DestroyAgent(agent) {
    await this.askText('destroy_agent', {agent: agent.name});
    this.agents.delete(agent.name);
  }

  // Command lines and runs --------------------------------------------------------------------------------------------------

  async commitAll() {
    for (const agent of this.agents.values()) await agent.Commit();
  }
  async ExecuteCommandLine(line, agent) {
    await this.commitAll();
    const response = await this.ask('cmdline', {agent, line, echo: 'false', nofilter: 'false'}, [], {output: 'raw'});
    const error = response.child('error');
    this.lastResult = error === undefined;
    return error?.text ?? response.child('result')?.text ?? '';
  }
  GetLastCommandLineResult() {
    return this.lastResult;
  }
  async runAll(line) {
    await this.commitAll();
    for (const agent of this.agents.values()) agent.memory.added.clear();
    return this.ExecuteCommandLine(line);
  }
  async RunAllAgents(count, step = 'decision') {
    return this.runAll(runLine('', count, step));
  }
  async RunAllTilOutput() {
    return this.runAll('run --output');
  }
  async RunAllAgentsForever() {
    return this.runAll('run');
  }
  StopAllAgents() {
    return this.ExecuteCommandLine('stop-soar');
  }
  GetSoarKernelVersion() {
    return this.askText('version');
  }

  // Events ------------------------------------------------------------------------------------------------------------------

  key(event, about) {
    return about === undefined ? event : `${event} ${about}`;
  }
  handlersOf(event, about) {
    return [...(this.handlers.get(this.key(event, about)) ?? new Map()).values()];
  }
  addHandler(key, handler) {
    this.lastHandler += 1;
    if (!this.handlers.has(key)) this.handlers.set(key, new Map());
    this.handlers.get(key).set(this.lastHandler, handler);
    return this.lastHandler;
  }
  async register(event, agent, handler) {
    const key = this.key(event, agent), isFirst = !(this.handlers.get(key)?.size > 0);
    const number = this.addHandler(key, handler);
    if (!isFirst) return number;
    try {
      await this.askText('register_for_event', {agent, eventid: event});
    } catch (problem) {
      this.UnregisterForEvent(number);
      throw new Error(`cannot register for the event '${event}': ${problem.message}`);
    }
    return number;
  }
  RegisterForSystemEvent(event, handler) {
    return this.register(event, undefined, () => handler(this));
  }
  RegisterForUpdateEvent(event, handler) {
    return this.register(event, undefined, (given) => handler(this, Number(given.arg('value'))));
  }
  RegisterForAgentEvent(event, handler) {
    return this.register(event, undefined, (given) => handler(this.agents.get(given.arg('name')) ?? null, given.arg('name')));
  }
  /** `handler(agent, name, argument)` returns the value of the function, as text. */
  async AddRhsFunction(name, handler) {
    const number = this.addHandler(`rhs-user-function ${name}`, handler);
    await this.askText('register_for_event', {eventid: 'rhs-user-function', name});
    return number;
  }
  async RegisterForClientMessageEvent(name, handler) {
    const number = this.addHandler(`client-message ${name}`, handler);
    await this.askText('register_for_event', {eventid: 'client-message', name});
    return number;
  }
  SendClientMessage(agent, name, message) {
    return this.askText('send_client_message', {agent: agent?.name, name, message});
  }
  /** `number`: what the registration returned. The handler is not called any more. */
  UnregisterForEvent(number) {
    return [...this.handlers.values()].some((handlers) => handlers.delete(number));
  }

  /** Disconnects. The kernel and its agents go on. */
  Shutdown() {
    this.end(new Error('the kernel was shut down by this program'));
    this.link.close();
  }
}

module.exports = {Agent, Identifier, Kernel, WMElement};
