// SPDX-License-Identifier: BSD-2-Clause
// Encodes and decodes an Entity State PDU with open-dis, a library that others wrote: node open_dis.js encode X Y Z, or
// node open_dis.js decode HEX.
'use strict';
const dis = require('open-dis');

if (process.argv[2] === 'encode') {
  const [x, y, z] = process.argv.slice(3, 6).map(Number);
  const pdu = new dis.EntityStatePdu();
  pdu.exerciseID = 1;
  pdu.forceId = 2;
  pdu.entityID.site = 40;
  pdu.entityID.application = 41;
  pdu.entityID.entity = 42;
  pdu.entityType.entityKind = 3;
  pdu.entityType.domain = 1;
  pdu.entityType.country = 225;
  pdu.entityType.category = 1;
  pdu.entityLocation.x = x;
  pdu.entityLocation.y = y;
  pdu.entityLocation.z = z;
  pdu.marking.characterSet = 1;
  pdu.marking.setMarking('open-dis');
  const stream = new dis.OutputStream(new ArrayBuffer(2048));
  pdu.encodeToBinary(stream);
  const bytes = Buffer.from(stream.binaryData, 0, stream.currentPosition);
  bytes.writeUInt16BE(bytes.length, 8);
  console.log(bytes.toString('hex'));
} else {
  const bytes = Buffer.from(process.argv[3], 'hex');
  const pdu = new dis.PduFactory().createPdu(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  console.log(JSON.stringify({
    entityID: [pdu.entityID.site, pdu.entityID.application, pdu.entityID.entity],
    forceId: pdu.forceId,
    marking: pdu.marking.getMarking().replace(/\0/g, ''),
    location: [pdu.entityLocation.x, pdu.entityLocation.y, pdu.entityLocation.z],
  }));
}
