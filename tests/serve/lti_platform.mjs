// SPDX-License-Identifier: BSD-2-Clause
// A learning platform for tests: the platform's side of LTI 1.3 (1EdTech Security Framework 1.0, LTI Core 1.3, Assignment and
// Grade Services 2.0, Deep Linking 2.0), with the cryptography of Node.js. It is strict: it refuses and records everything
// that a real platform could refuse.
//
// usage: node lti_platform.mjs [CERTIFICATE KEY]
// The first line of output is its address. GET /control returns its records; POST /control {"tool": URL, ...}
// changes its state.
import crypto from "node:crypto";
import fs from "node:fs";
import http from "node:http";
import https from "node:https";

const CLAIM = "https://purl.imsglobal.org/spec/lti/claim/", DEEP = "https://purl.imsglobal.org/spec/lti-dl/claim/";
const AGS = "https://purl.imsglobal.org/spec/lti-ags/", SCORE = `${AGS}scope/score`, CLIENT = "client-1", DEPLOYMENT = "deployment-1";
const ROLE = "http://purl.imsglobal.org/vocab/lis/v2/membership#";
const USERS = {
  ada: { sub: "user-ada", name: "Ada Lovelace", roles: [`${ROLE}Learner`] },
  bob: { sub: "user-bob", given_name: "Bob", family_name: "<b>Stone</b>", roles: [`${ROLE}Learner`] },
  zoe: { sub: "user-zoe", roles: [`${ROLE}Learner`] },
  teacher: { sub: "user-teacher", name: "Grace Hopper", roles: [`${ROLE}Instructor`] },
};

const newKey = () => ({ id: crypto.randomUUID(), ...crypto.generateKeyPairSync("rsa", { modulusLength: 2048 }) });
const state = { tool: "", keys: [newKey()], failures: [], tokens: new Map(), assertions: new Set() };
const noted = { jwks: 0, tokens: 0, scores: [], attempts: 0, choices: [], refused: [] };
const stranger = newKey();
const pack = (value) => Buffer.from(typeof value === "string" ? value : JSON.stringify(value)).toString("base64url");
const unpack = (text) => JSON.parse(Buffer.from(text, "base64url").toString("utf8"));
const seconds = () => Math.floor(Date.now() / 1000);

class Refusal extends Error {
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}
const demand = (condition, message, status = 400) => {
  if (!condition) throw new Refusal(status, message);
};

/** A token with these claims. `forge` is the mistake in its signature; empty: none. */
function sign(claims, forge = "") {
  const key = forge === "unknown-key" ? stranger : state.keys.at(-1);
  const header = { typ: "JWT", alg: forge === "none" ? "none" : forge === "hs256" ? "HS256" : forge === "rs512" ? "RS512" : "RS256", kid: key.id };
  if (forge === "no-kid") delete header.kid;
  const text = `${pack(header)}.${pack(claims)}`;
  if (forge === "none") return `${text}.`;
  // Uses the public key as the secret of an HMAC. A tool that trusts the header's algorithm would accept it.
  if (forge.startsWith("hs256") || forge === "hmac-as-rs256") {
    const pem = key.publicKey.export({ type: "spki", format: "pem" });
    return `${text}.${crypto.createHmac("sha256", pem).update(text).digest("base64url")}`;
  }
  const signer = forge === "wrong-key" ? stranger.privateKey : key.privateKey;
  const signature = crypto.sign(forge === "rs512" ? "sha512" : "sha256", Buffer.from(text), signer).toString("base64url");
  if (forge === "changed") return `${pack(header)}.${pack({ ...claims, sub: "user-bob" })}.${signature}`;
  if (forge === "no-signature") return `${text}.`;
  return `${text}.${signature}`;
}

/** Returns the claims of a token from the tool, after all checks that a platform must make. */
async function verified(token) {
  const parts = token.split(".");
  demand(parts.length === 3, "no token");
  const header = unpack(parts[0]), claims = unpack(parts[1]);
  demand(header.alg === "RS256" && typeof header.kid === "string", "not RS256 with a kid");
  const set = await (await fetch(`${state.tool}/lti/jwks`)).json();
  const key = set.keys.find((one) => one.kid === header.kid);
  demand(key !== undefined && key.kty === "RSA" && key.use === "sig" && key.alg === "RS256", "the key is not published");
  demand(key.d === undefined && key.p === undefined, "the private key is published");
  demand(crypto.verify("sha256", Buffer.from(`${parts[0]}.${parts[1]}`), crypto.createPublicKey({ key, format: "jwk" }), Buffer.from(parts[2], "base64url")), "wrong signature");
  demand(Number.isInteger(claims.iat) && Number.isInteger(claims.exp) && claims.iat <= seconds() + 5 && claims.exp > seconds() && claims.exp - claims.iat <= 3600, "wrong times");
  return claims;
}

function idToken(query) {
  const hint = query.get("lti_message_hint"), message = hint === null ? {} : unpack(hint);
  const user = USERS[query.get("login_hint")];
  demand(user !== undefined, "unknown login_hint");
  const { roles, ...person } = user;
  const claims = {
    iss: address, aud: CLIENT, iat: seconds(), exp: seconds() + 300, nonce: query.get("nonce"), ...person,
    [`${CLAIM}version`]: "1.3.0", [`${CLAIM}message_type`]: "LtiResourceLinkRequest", [`${CLAIM}deployment_id`]: DEPLOYMENT, [`${CLAIM}roles`]: roles,
    [`${CLAIM}target_link_uri`]: `${state.tool}/lti/launch`, [`${CLAIM}resource_link`]: { id: message.link ?? "link-1", title: "A lesson" },
    [`${CLAIM}context`]: { id: message.course ?? "course-1", label: "SOAR", title: "Soar for beginners", type: ["http://purl.imsglobal.org/vocab/lis/v2/course#CourseOffering"] },
    [`${CLAIM}tool_platform`]: { guid: "test-platform", product_family_code: "soarbox-test" },
    [`${CLAIM}launch_presentation`]: { document_target: "window", locale: "en" },
    [`${CLAIM}custom`]: { lesson: message.lesson ?? "01-a-rule" },
    [`${AGS}claim/endpoint`]: { scope: [`${AGS}scope/lineitem.readonly`, SCORE], lineitems: `${address}/items`, lineitem: `${address}/items/${message.item ?? "1"}?type_id=4` },
  };
  if (message.chooses) {
    claims[`${CLAIM}message_type`] = "LtiDeepLinkingRequest";
    delete claims[`${CLAIM}resource_link`];
    claims[`${DEEP}deep_linking_settings`] = { deep_link_return_url: `${address}/chosen`, accept_types: ["ltiResourceLink", "link"], accept_presentation_document_targets: ["window"], accept_multiple: true, data: "csrf:1" };
  }
  Object.assign(claims, message.set);
  for (const name of message.remove ?? []) delete claims[name];
  return sign(claims, message.forge);
}

function authorize(query) {
  const expected = { scope: "openid", response_type: "id_token", response_mode: "form_post", prompt: "none", client_id: CLIENT, redirect_uri: `${state.tool}/lti/launch` };
  for (const [name, value] of Object.entries(expected)) demand(query.get(name) === value, `${name} is ${query.get(name)}, not ${value}`);
  for (const name of ["state", "nonce"]) demand((query.get(name) ?? "").length >= 16, `${name} can be guessed`);
  const fields = { id_token: idToken(query), state: query.get("state") };
  const inputs = Object.entries(fields).map(([name, value]) => `<input type="hidden" name="${name}" value="${value}">`);
  return { type: "text/html", body: `<form method="post" action="${query.get("redirect_uri")}">${inputs.join("")}</form><script>document.forms[0].submit()</script>` };
}

async function giveToken(request, body) {
  demand(request.headers["content-type"] === "application/x-www-form-urlencoded", "wrong content type");
  const form = new URLSearchParams(body);
  demand(form.get("grant_type") === "client_credentials", "wrong grant_type");
  demand(form.get("client_assertion_type") === "urn:ietf:params:oauth:client-assertion-type:jwt-bearer", "wrong client_assertion_type");
  demand(form.get("scope") === SCORE, "wrong scope");
  const claims = await verified(form.get("client_assertion") ?? "");
  demand(claims.iss === CLIENT && claims.sub === CLIENT, "iss and sub must be the client", 401);
  demand(claims.aud === `${address}/token` || (Array.isArray(claims.aud) && claims.aud.includes(`${address}/token`)), "wrong aud", 401);
  demand(typeof claims.jti === "string" && !state.assertions.has(claims.jti), "jti was used before", 401);
  state.assertions.add(claims.jti);
  const token = crypto.randomUUID();
  state.tokens.set(token, seconds() + 3600);
  ++noted.tokens;
  return { body: JSON.stringify({ access_token: token, token_type: "bearer", expires_in: 3600, scope: SCORE }) };
}

function takeScore(request, item, query, body) {
  ++noted.attempts;
  const failure = state.failures.shift();
  if (failure === 401) state.tokens.clear();
  if (failure !== undefined) throw new Refusal(failure, "as the test wants it");
  const token = /^Bearer (.+)$/.exec(request.headers.authorization ?? "")?.[1];
  demand(token !== undefined && (state.tokens.get(token) ?? 0) > seconds(), "no valid access token", 401);
  demand(request.headers["content-type"] === "application/vnd.ims.lis.v1.score+json", "wrong content type", 415);
  demand(query.get("type_id") === "4", "the query of the line item is lost", 404);
  const score = JSON.parse(body), known = Object.values(USERS).map((user) => user.sub);
  demand(known.includes(score.userId), "no such user");
  demand(/^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d+(Z|[+-]\d\d:\d\d)$/.test(score.timestamp) && !Number.isNaN(Date.parse(score.timestamp)), "wrong timestamp");
  demand(["Initialized", "Started", "InProgress", "Submitted", "Completed"].includes(score.activityProgress), "wrong activityProgress");
  demand(["FullyGraded", "Pending", "PendingManual", "Failed", "NotReady"].includes(score.gradingProgress), "wrong gradingProgress");
  demand(typeof score.scoreGiven === "number" && score.scoreGiven >= 0 && typeof score.scoreMaximum === "number" && score.scoreMaximum > 0, "wrong score");
  const before = noted.scores.filter((one) => one.item === item && one.userId === score.userId).at(-1);
  demand(before === undefined || Date.parse(before.timestamp) < Date.parse(score.timestamp), "a later score is known", 409);
  noted.scores.push({ item, ...score });
  return { status: 200, body: "" };
}

async function takeChoice(body) {
  const claims = await verified(new URLSearchParams(body).get("JWT") ?? "");
  demand(claims.iss === CLIENT, "wrong iss");
  demand(claims.aud === address || (Array.isArray(claims.aud) && claims.aud.includes(address)), "wrong aud");
  demand(typeof claims.nonce === "string" && claims.nonce.length > 8, "no nonce");
  demand(claims[`${CLAIM}deployment_id`] === DEPLOYMENT && claims[`${CLAIM}message_type`] === "LtiDeepLinkingResponse" && claims[`${CLAIM}version`] === "1.3.0", "wrong message");
  demand(claims[`${DEEP}data`] === "csrf:1", "data is lost");
  const items = claims[`${DEEP}content_items`];
  demand(Array.isArray(items) && items.every((one) => one.type === "ltiResourceLink" && one.url.startsWith(`${state.tool}/lti/launch`) && one.lineItem.scoreMaximum > 0), "wrong content items");
  noted.choices.push(items);
  return { body: "chosen", type: "text/plain" };
}

function control(order) {
  if (order.tool !== undefined) state.tool = order.tool;
  if (order.failures !== undefined) state.failures = order.failures;
  if (order.rotate) state.keys = [newKey()];
  return { body: "{}" };
}

async function answer(request, body) {
  const url = new URL(request.url, address), path = url.pathname, item = /^\/items\/(\w+)\/scores$/.exec(path)?.[1];
  if (path === "/control") return request.method === "POST" ? control(JSON.parse(body)) : { body: JSON.stringify(noted) };
  if (path === "/jwks") {
    ++noted.jwks;
    const jwk = (key) => ({ ...key.publicKey.export({ format: "jwk" }), kid: key.id, use: "sig", alg: "RS256" });
    return { body: JSON.stringify({ keys: [...state.keys.map(jwk), { kty: "EC", crv: "P-256", kid: "other", x: "AA", y: "AA" }] }) };
  }
  if (path === "/auth") return authorize(url.searchParams);
  if (path === "/token" && request.method === "POST") return giveToken(request, body);
  if (item !== undefined && request.method === "POST") return takeScore(request, item, url.searchParams, body);
  if (path === "/chosen" && request.method === "POST") return takeChoice(body);
  throw new Refusal(404, `nothing at ${path}`);
}

const serve = (request, response) => {
  const pieces = [];
  request.on("data", (piece) => pieces.push(piece));
  request.on("end", () => void answer(request, Buffer.concat(pieces).toString("utf8")).catch((error) => {
    const status = error instanceof Refusal ? error.status : 500;
    noted.refused.push(`${request.url.split("?")[0]}: ${error.message}`);
    return { status, body: JSON.stringify({ error: error.message }) };
  }).then(({ status = 200, type = "application/json", body }) => response.writeHead(status, { "Content-Type": type, Connection: "close" }).end(body)));
};
const [, , certificate, key] = process.argv;
const server = certificate === undefined ? http.createServer(serve) : https.createServer({ cert: fs.readFileSync(certificate), key: fs.readFileSync(key) }, serve);
let address = "";
server.listen(0, "127.0.0.1", () => {
  address = `${certificate === undefined ? "http://127.0.0.1" : "https://localhost"}:${server.address().port}`;
  console.log(address);
});
