// SPDX-License-Identifier: BSD-2-Clause
// The protocol between a Soar kernel and its clients: XML documents, and their transport over a socket (4 bytes with the length before each).
'use strict';

const {connect} = require('node:net');

const ESCAPES = {'<': '&lt;', '>': '&gt;', '&': '&amp;', '"': '&quot;', "'": '&apos;'};
const ENTITIES = {lt: '<', gt: '>', amp: '&', quot: '"', apos: "'"};
const TOKEN = /<(\/?)([\w.:-]+)((?:\s+[\w.:-]+\s*=\s*(?:"[^"]*"|'[^']*'))*)\s*(\/?)>|([^<]+)/y;
const ATTRIBUTE = /([\w.:-]+)\s*=\s*(?:"([^"]*)"|'([^']*)')/g;
const SML_VERSION = '9.6.3';
const HEADER_BYTES = 4, MOST_BYTES = 64 << 20;

const escape = (text) => String(text).replace(/[<>&"']/g, (letter) => ESCAPES[letter]);

function unescape(text) {
  return text.replace(/&(?:#x([\da-f]+)|#(\d+)|(\w+));/gi, (all, hex, decimal, name) => {
    if (hex !== undefined) return String.fromCodePoint(parseInt(hex, 16));
    if (decimal !== undefined) return String.fromCodePoint(Number(decimal));
    return ENTITIES[name] ?? all;
  });
}

/** An XML element: its tag, attributes, children and text. */
class Element {
  constructor(tag, attributes = {}, text = '') {
    this.tag = tag;
    this.attributes = attributes;
    this.children = [];
    this.text = text;
  }
  add(tag, attributes, text) {
    const child = new Element(tag, attributes, text);
    this.children.push(child);
    return child;
  }
  child(tag) {
    return this.children.find((each) => each.tag === tag);
  }
  addArg(name, value) {
    this.add('arg', {param: name}, String(value));
    return this;
  }
  /** The value of an <arg>, or undefined. */
  arg(name) {
    return this.children.find((each) => each.tag === 'arg' && each.attributes.param === name)?.text;
  }
  toString() {
    const attributes = Object.keys(this.attributes).sort().map((name) => ` ${name}="${escape(this.attributes[name])}"`).join('');
    return `<${this.tag}${attributes}>${escape(this.text)}${this.children.join('')}</${this.tag}>`;
  }
}

/** Throws if the document is not XML with one root. */
function readXml(document) {
  const top = new Element('');
  const open = [top];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < document.length) {
    const at = TOKEN.lastIndex, token = TOKEN.exec(document);
    if (token === null) throw new Error(`the kernel sent a document that is not XML, at byte ${at}: ${document.slice(at, at + 40)}`);
    const [, end, tag, attributes, closed, text] = token, current = open[open.length - 1];
    if (text !== undefined) {
      current.text += unescape(text);
    } else if (end) {
      if (current.tag !== tag) throw new Error(`the kernel sent a document in which </${tag}> ends <${current.tag}>`);
      open.pop();
    } else {
      const values = {};
      for (const [, name, quoted, apostrophed] of attributes.matchAll(ATTRIBUTE)) values[name] = unescape(quoted ?? apostrophed);
      const child = current.add(tag, values);
      if (!closed) open.push(child);
    }
  }
  if (open.length !== 1 || top.children.length !== 1) throw new Error('the kernel sent a document that is not complete');
  return top.children[0];
}

/** The document of a call or a response with these contents. */
function newDocument(type, id, children, ack) {
  const root = new Element('sml', {doctype: type, id, smlversion: SML_VERSION});
  if (ack !== undefined) root.attributes.ack = ack;
  root.children = children;
  return root.toString();
}

/** A connection to a kernel in another process. `took(document)` gets each document, `ended(problem)` the end. */
class SocketLink {
  static open(address, port, took, ended) {
    return new Promise((done, failed) => {
      const socket = connect({host: address, port});
      const refuse = (problem) => failed(new Error(`no kernel at ${address}:${port} (${problem.code}): soarbox kernel starts one`));
      socket.once('error', refuse);
      socket.once('connect', () => {
        socket.off('error', refuse);
        socket.setNoDelay(true);
        done(new SocketLink(socket, took, ended));
      });
    });
  }
  constructor(socket, took, ended) {
    this.socket = socket;
    let waiting = Buffer.alloc(0);
    socket.on('data', (bytes) => {
      waiting = waiting.length === 0 ? bytes : Buffer.concat([waiting, bytes]);
      while (waiting.length >= HEADER_BYTES) {
        const end = HEADER_BYTES + waiting.readUInt32BE(0);
        if (end > MOST_BYTES) return socket.destroy(new Error('the kernel sent a message of more than 64 MB'));
        if (waiting.length < end) break;
        took(waiting.toString('utf8', HEADER_BYTES, end));
        waiting = waiting.subarray(end);
      }
    });
    socket.on('error', (problem) => ended(problem));
    socket.on('close', () => ended(new Error('the connection to the kernel has ended')));
  }
  send(document) {
    const bytes = Buffer.from(document, 'utf8'), header = Buffer.alloc(HEADER_BYTES);
    header.writeUInt32BE(bytes.length);
    this.socket.write(Buffer.concat([header, bytes]));
  }
  close() {
    this.socket.end();
  }
}

module.exports = {Element, SocketLink, newDocument, readXml};
