// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { ArenaInfo, GameInfo, Tournament } from "../app/api";

/** Actions in the arena; a missing one is not available. */
export interface ArenaEvents {
  /** Shows the recording of a match. */
  replay?(match: string): void;
  play?(game: string, seeds: number): void;
}

const SEEDS = [1, 3, 5, 10] as const;

function ladderView(tournament: Tournament, title: string): View {
  const columns = ["Points", "Won", "Drawn", "Lost", "Scored", "Conceded"];
  return h("table.ladder", { attributes: { "aria-label": `Ladder of ${title}` } },
    h("thead", null, h("tr", null, h("th.number", { attributes: { scope: "col" } }, "Place"), h("th", { attributes: { scope: "col" } }, "Learner"), columns.map((one) => h("th.number", { attributes: { scope: "col" } }, one)))),
    h("tbody", null, tournament.ladder.map((row, i) => h("tr", { key: `${i} ${row.learner}` }, h("td.number", null, i + 1), h("th", { attributes: { scope: "row" } }, row.learner),
      [row.points, row.won, row.drawn, row.lost, row.scored, row.conceded].map((value) => h("td.number", null, String(Math.round(value * 100) / 100)))))));
}

function matchView(match: Tournament["matches"][number], isPlaying: boolean, events: ArenaEvents): View {
  const [one, two] = match.learners, { scores, replay } = match;
  return h("li.row", { key: `${one} ${two} ${match.seed}` }, h("span.names", null, `${one} against ${two}`), h("span.quiet", null, `seed ${match.seed}`),
    scores !== null ? h("b", null, `${scores[0]} : ${scores[1]}`) : h("span.quiet", null, match.trouble !== "" ? match.trouble : isPlaying ? "not played yet" : "no result"),
    replay !== null && events.replay !== undefined && button("Replay", () => events.replay?.(replay), { attributes: { "aria-label": `Replay of ${one} against ${two}, seed ${match.seed}` } }, "button.small"));
}

/** The state or the result of the last tournament. */
export function tournamentView(game: GameInfo, events: ArenaEvents): Child {
  const { tournament } = game;
  if (tournament === null) return h("p.quiet", null, "No tournament has been played yet.");
  const { seeds, matches, is_playing: isPlaying, played } = tournament;
  return [
    isPlaying && h("div.row", { attributes: { role: "status" } }, h("progress", { attributes: { max: matches.length, value: played, "aria-label": `${played} of ${matches.length} matches played` } }), h("span", null, `${played} of ${matches.length} matches played`)),
    ladderView(tournament, game.title),
    h("p.quiet", null, `All pairs play with ${seeds === 1 ? "seed 1" : `seeds 1 to ${seeds}`}, at most ${game.seconds} s each. A win brings 2 points, a draw 1; then the difference of scores decides. Each seed changes who is placed first.`),
    h("details", null, h("summary", null, `${matches.length} ${matches.length === 1 ? "match" : "matches"}`), h("ul.plain.matches", null, matches.map((one) => matchView(one, isPlaying, events)))),
  ];
}

/** The teacher's view of the arena: the entries, the tournament, and its button. */
export function arenaView(info: ArenaInfo, chosenSeeds: number, setSeeds: (seeds: number) => void, events: ArenaEvents): View {
  return h("section.arena", { attributes: { "aria-label": "Arena" } }, h("h2", null, "Arena"), info.games.map((game) => h("section.game", { key: game.name }, h("h3", null, game.title),
    h("p", null, game.entries.length === 0 ? "Nobody has handed in rules yet. Learners do it on their first page." : `Handed in: ${game.entries.map((one) => one.learner).join(", ")}.`),
    events.play !== undefined && h("div.row", null,
      h("label.row", null, "Seeds", h("select", { value: String(chosenSeeds), attributes: { "aria-label": `Seeds of ${game.title}` }, on: { change: (event) => setSeeds(Number((event.target as HTMLSelectElement).value)) } }, SEEDS.map((one) => h("option", { attributes: { value: one } }, one === 1 ? "1" : `1 to ${one}`)))),
      button(`Play ${game.title}`, () => events.play?.(game.name, chosenSeeds), { attributes: { disabled: game.entries.length < 2 || game.tournament?.is_playing === true, title: game.entries.length < 2 ? "Two learners have to hand in rules first" : "All pairs play with each seed. The ladder and the matches before are removed." } }, "button.primary")),
    tournamentView(game, events))));
}

/** The learner's view of the arena: hand in, ladder, replays. `files`: the files of the place. */
export function learnersArena(info: ArenaInfo, files: readonly { path: string }[], handIn: (game: string, file: string) => void, events: ArenaEvents): View {
  return h("section.arena", { attributes: { "aria-label": "Arena" } }, h("h2", null, "Arena"), h("p.quiet", null, "Hand in rules for a game. Your teacher lets all that were handed in play against each other."),
    info.games.map((game) => {
      const choices = files.map((one) => one.path).filter((path) => path.endsWith(".soar") && path.startsWith(`worlds/${game.name}/`));
      return h("section.game", { key: game.name }, h("h3", null, game.title),
        game.mine !== null && h("p", null, `You have handed in ${game.mine.file}.`, " ", h("span.quiet", null, "Hand in again to replace it.")),
        choices.length === 0 ? h("p.quiet", null, `Open the world ${game.name}, change its rules and apply them: then you can hand them in here.`)
          : h("div.row", null, choices.map((path) => button(`Hand in ${path.split("/").at(-1)}`, () => handIn(game.name, path), { key: path, attributes: { title: path } }))),
        tournamentView(game, events));
    }));
}
