// SPDX-License-Identifier: BSD-2-Clause
// The input and output of one agent, as its client sees them.
'use strict';

const {Element} = require('./sml_wire');

/** One element of working memory that a client created, or of an agent's output. */
class WMElement {
  constructor(memory, parent, attribute, type, value, tag) {
    Object.assign(this, {memory, parent, attribute, type, value, tag});
  }
  GetAttribute() {
    return this.attribute;
  }
  GetValue() {
    return this.value;
  }
  GetValueAsString() {
    return String(this.value);
  }
  GetValueType() {
    return this.type;
  }
  GetTimeTag() {
    return this.tag;
  }
  GetIdentifierName() {
    return this.parent.GetValueAsString();
  }
  IsIdentifier() {
    return false;
  }
  DestroyWME() {
    this.memory.remove(this);
  }
  /** Replaces the value of an element of the input. */
  Update(value) {
    this.memory.update(this, value);
  }
}

/** An element whose value is an identifier. Its value is the identifier's name. */
class Identifier extends WMElement {
  constructor(memory, parent, attribute, name, tag, symbol) {
    super(memory, parent, attribute, 'id', name, tag);
    /** The elements of the identifier: the same for all elements with this value. */
    this.symbol = symbol ?? {children: []};
  }
  IsIdentifier() {
    return true;
  }
  GetNumberChildren() {
    return this.symbol.children.length;
  }
  GetChild(index) {
    return this.symbol.children[index] ?? null;
  }
  FindByAttribute(attribute, index = 0) {
    return this.symbol.children.filter((each) => each.attribute === attribute)[index] ?? null;
  }
  GetCommandName() {
    return this.attribute;
  }
  /** The value as text, or null if there is no such parameter. */
  GetParameterValue(attribute) {
    return this.FindByAttribute(attribute)?.GetValueAsString() ?? null;
  }
  CreateStringWME(attribute, value) {
    return this.memory.create(this, attribute, 'string', value);
  }
  CreateIntWME(attribute, value) {
    return this.memory.create(this, attribute, 'int', value);
  }
  CreateFloatWME(attribute, value) {
    return this.memory.create(this, attribute, 'double', value);
  }
  CreateIdWME(attribute) {
    return this.memory.create(this, attribute, 'id');
  }
  CreateSharedIdWME(attribute, shared) {
    return this.memory.create(this, attribute, 'id', shared);
  }
  AddStatusComplete() {
    this.CreateStringWME('status', 'complete');
  }
  AddStatusError() {
    this.CreateStringWME('status', 'error');
  }
  AddErrorCode(code) {
    this.CreateIntWME('error-code', code);
  }
}

/** What a value must be; throws a TypeError otherwise. */
function checkValue(type, value) {
  const isInteger = typeof value === 'bigint' || Number.isSafeInteger(value);
  if (type === 'int' && !isInteger) throw new TypeError(`an integer is expected, not ${value}`);
  if (type === 'double' && !Number.isFinite(value)) throw new TypeError(`a finite number is expected, not ${value}`);
  if (type === 'string' && typeof value !== 'string') throw new TypeError(`a string is expected, not ${value}`);
  return value;
}

/** A value as the kernel sent it. Integers that a number cannot hold exactly are a bigint. */
function readValue(type, text) {
  if (type === 'double') return Number(text);
  if (type !== 'int') return text;
  return Number.isSafeInteger(Number(text)) ? Number(text) : BigInt(text);
}

/** Changes of the input wait here until the kernel gets them, in order, with the next Commit, run or command line. */
class Memory {
  constructor(takeTag) {
    this.takeTag = takeTag;
    this.changes = [];
    this.inputLink = null;
    this.names = 0;
    this.forgetOutput();
  }

  forgetOutput() {
    this.outputLink = null;
    this.output = new Map();  // By time tag.
    this.symbols = new Map();  // By the identifier's name.
    this.added = new Set();  // Since the last run began.
  }

  // Input -------------------------------------------------------------------------------------------------------------

  create(parent, attribute, type, given) {
    if (typeof attribute !== 'string' || attribute === '') throw new TypeError('an attribute is a text with at least one letter');
    const tag = this.takeTag();
    const made = type === 'id' ? new Identifier(this, parent, attribute, given?.value ?? this.newName(attribute), tag, given?.symbol)
      : new WMElement(this, parent, attribute, type, checkValue(type, given), tag);
    parent.symbol.children.push(made);
    this.addChange(made);
    return made;
  }

  newName(attribute) {
    this.names += 1;
    return (/^[a-z]/i.test(attribute) ? attribute[0].toLowerCase() : 'i') + this.names;
  }

  addChange(wme) {
    const attributes = {action: 'add', attr: wme.attribute, id: wme.parent.value, tag: String(wme.tag), value: String(wme.value)};
    if (wme.type !== 'string') attributes.valtype = wme.type;
    this.changes.push(new Element('wme', attributes));
  }

  remove(wme) {
    if (wme.parent === null || !wme.parent.symbol.children.includes(wme)) throw new Error('this element is removed already, or is a link');
    wme.parent.symbol.children.splice(wme.parent.symbol.children.indexOf(wme), 1);
    this.changes.push(new Element('wme', {action: 'remove', tag: String(wme.tag)}));
  }

  update(wme, value) {
    if (wme.type === 'id') throw new TypeError('an identifier cannot be updated: destroy it and create another');
    checkValue(wme.type, value);
    if (value === wme.value) return;
    this.changes.push(new Element('wme', {action: 'remove', tag: String(wme.tag)}));
    Object.assign(wme, {tag: this.takeTag(), value});
    this.addChange(wme);
  }

  /** After init-soar, an agent has no input: everything is created again. */
  renew(nameOfLink) {
    this.changes = [];
    this.forgetOutput();
    if (this.inputLink === null) return;
    this.inputLink.value = nameOfLink;
    const seen = new Set();
    const visit = (identifier) => {
      if (seen.has(identifier.symbol)) return;
      seen.add(identifier.symbol);
      for (const wme of identifier.symbol.children) {
        wme.tag = this.takeTag();
        this.addChange(wme);
        if (wme.type === 'id') visit(wme);
      }
    };
    visit(this.inputLink);
  }

  takeChanges() {
    const changes = this.changes;
    this.changes = [];
    return changes;
  }

  // Output ------------------------------------------------------------------------------------------------------------

  symbolOf(name) {
    if (!this.symbols.has(name)) this.symbols.set(name, {children: []});
    return this.symbols.get(name);
  }

  /** Changes of the output, as the kernel sends them. */
  receive(wmes) {
    for (const {attributes} of wmes) {
      const tag = Number(attributes.tag);
      if (attributes.action === 'remove') this.forget(tag);
      else if (!this.output.has(tag)) this.receiveOne(tag, attributes);
    }
  }

  receiveOne(tag, {attr, id, value, valtype}) {
    const isLink = attr === 'output-link' && this.outputLink === null;
    const parent = isLink ? null : {symbol: this.symbolOf(id), value: id, GetValueAsString: () => id};
    const wme = valtype === 'id' ? new Identifier(this, parent, attr, value, tag, this.symbolOf(value))
      : new WMElement(this, parent, attr, valtype ?? 'string', readValue(valtype, value), tag);
    this.output.set(tag, wme);
    if (isLink) {
      this.outputLink = wme;
      return;
    }
    parent.symbol.children.push(wme);
    this.added.add(wme);
  }

  forget(tag) {
    const wme = this.output.get(tag);
    if (wme === undefined || wme === this.outputLink) return;
    const {children} = wme.parent.symbol;
    children.splice(children.indexOf(wme), 1);
    this.output.delete(tag);
    this.added.delete(wme);
  }

  /** New elements of the output link since the last run began. */
  newElements() {
    return [...this.added].filter((wme) => this.outputLink !== null && wme.parent.symbol === this.outputLink.symbol);
  }
}

module.exports = {Identifier, Memory, WMElement};
