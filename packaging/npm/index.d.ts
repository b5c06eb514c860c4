// SPDX-License-Identifier: BSD-2-Clause
// Soar agents and Soarbox's worlds from JavaScript. The names are those of Soar's own client library.
//
// Everything that asks the kernel returns a promise. Handlers of events may be asynchronous: the kernel waits for them, but
// for output and functions at most 2 s.

export type Value = string | number | bigint;
export type Step = "phase" | "elaboration" | "decision" | "output";
type Answer<T> = T | Promise<T>;

export class WMElement {
  protected constructor();
  GetAttribute(): string;
  GetValue(): Value;
  GetValueAsString(): string;
  GetValueType(): "string" | "int" | "double" | "id";
  GetTimeTag(): number;
  GetIdentifierName(): string;
  IsIdentifier(): this is Identifier;
  DestroyWME(): void;
  /** Replaces the value of an element of the input. Throws if the value is of another type. */
  Update(value: Value): void;
}

/** An element whose value is an identifier, for example a command. */
export class Identifier extends WMElement {
  GetNumberChildren(): number;
  GetChild(index: number): WMElement | null;
  FindByAttribute(attribute: string, index?: number): WMElement | null;
  GetCommandName(): string;
  GetParameterValue(attribute: string): string | null;
  CreateStringWME(attribute: string, value: string): WMElement;
  CreateIntWME(attribute: string, value: number | bigint): WMElement;
  CreateFloatWME(attribute: string, value: number): WMElement;
  CreateIdWME(attribute: string): Identifier;
  CreateSharedIdWME(attribute: string, shared: Identifier): Identifier;
  AddStatusComplete(): void;
  AddStatusError(): void;
  AddErrorCode(code: number): void;
}

export class Agent {
  private constructor();
  GetAgentName(): string;

  /** What the command printed. GetLastCommandLineResult() of the kernel says whether it worked. */
  ExecuteCommandLine(line: string): Promise<string>;
  /** Rejects with the errors of the file. */
  LoadProductions(file: string): Promise<string>;
  RunSelf(count: number, step?: Step): Promise<string>;
  RunSelfTilOutput(): Promise<string>;
  RunSelfForever(): Promise<string>;
  StopSelf(): Promise<string>;
  InitSoar(): Promise<string>;

  GetInputLink(): Promise<Identifier>;
  CreateStringWME(parent: Identifier, attribute: string, value: string): WMElement;
  CreateIntWME(parent: Identifier, attribute: string, value: number | bigint): WMElement;
  CreateFloatWME(parent: Identifier, attribute: string, value: number): WMElement;
  CreateIdWME(parent: Identifier, attribute: string): Identifier;
  CreateSharedIdWME(parent: Identifier, attribute: string, shared: Identifier): Identifier;
  Update(wme: WMElement, value: Value): void;
  DestroyWME(wme: WMElement): void;
  /** Changes of the input reach the kernel with the next Commit, run or command line. */
  Commit(): Promise<void>;
  IsCommitRequired(): boolean;

  /** Null before the first output. */
  GetOutputLink(): Identifier | null;
  /** Commands that are new since the last run began. */
  Commands(): boolean;
  GetNumberCommands(): number;
  GetCommand(index: number): Identifier | null;

  RegisterForPrintEvent(handler: (agent: Agent, text: string) => Answer<void>): Promise<number>;
  /** For example "after-decision-cycle". */
  RegisterForRunEvent(event: string, handler: (agent: Agent, phase: number) => Answer<void>): Promise<number>;
  /** For example "after-production-fired". */
  RegisterForProductionEvent(event: string, handler: (agent: Agent, rule: string) => Answer<void>): Promise<number>;
  AddOutputHandler(attribute: string, handler: (agent: Agent, attribute: string, wme: WMElement) => Answer<void>): number;
}

export class Kernel {
  private constructor();
  /** Connects to `soarbox kernel`, to a world that listens, or to Soar's own kernel. Default: 127.0.0.1, 12121. */
  static CreateRemoteConnection(address?: string, port?: number): Promise<Kernel>;

  CreateAgent(name: string): Promise<Agent>;
  GetAgent(name: string): Promise<Agent | null>;
  GetAgents(): Promise<Agent[]>;
  DestroyAgent(agent: Agent): Promise<void>;

  ExecuteCommandLine(line: string, agent?: string): Promise<string>;
  GetLastCommandLineResult(): boolean;
  RunAllAgents(count: number, step?: Step): Promise<string>;
  RunAllTilOutput(): Promise<string>;
  RunAllAgentsForever(): Promise<string>;
  StopAllAgents(): Promise<string>;
  GetSoarKernelVersion(): Promise<string>;

  /** For example "system-start". Registrations return a number for UnregisterForEvent. */
  RegisterForSystemEvent(event: string, handler: (kernel: Kernel) => Answer<void>): Promise<number>;
  RegisterForUpdateEvent(event: string, handler: (kernel: Kernel, flags: number) => Answer<void>): Promise<number>;
  RegisterForAgentEvent(event: string, handler: (agent: Agent | null, name: string) => Answer<void>): Promise<number>;
  AddRhsFunction(name: string, handler: (agent: Agent | null, name: string, argument: string) => Answer<Value>): Promise<number>;
  RegisterForClientMessageEvent(name: string, handler: (agent: Agent | null, name: string, message: string) => Answer<Value>): Promise<number>;
  SendClientMessage(agent: Agent | null, name: string, message: string): Promise<string>;
  UnregisterForEvent(number: number): boolean;

  /** Disconnects. The kernel and its agents go on. */
  Shutdown(): void;
}

export interface Place {
  /** The working folder. */
  cwd?: string;
  env?: Record<string, string | undefined>;
}

/** Runs `soarbox WORDS...`. `input` is what it reads from standard input. */
export function runCommand(words: (string | number)[], options?: Place & { input?: string }): Promise<{ code: number; stdout: string; stderr: string }>;

/** An event of a run: one line of `soarbox run --json`. */
export interface WorldEvent {
  event: string;
  [field: string]: unknown;
}

/** Runs a world without a window, at full speed. Leaving the loop ends the run. */
export function runWorld(world: string, options?: Place & { seconds?: number; seed?: number; record?: string }): AsyncGenerator<WorldEvent, void, void>;
