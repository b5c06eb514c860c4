#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks that no class has more than fifteen public functions, except classes that had more when this check was introduced.

usage: check_classes.py SOURCE_DIR [--list]

Functions are counted by name: overloads once; constructors, destructors and operators are not counted. The client API
(src/sml/client/sml_*.h) is not checked, because its functions are those of Soar. ALLOWED contains the limits of the old
classes. A limit must not grow: if a class has become smaller, the check prints the new limit for this table. The exit
status is 1 if a class is too large; each is printed.
"""
import pathlib
import re
import sys

MOST = 15
ALLOWED = {
    "kernel/agent.h Agent": 90,
    "world/agent.h Agent": 70,
    "kernel/match/rete_state.h ReteState": 65,
    "kernel/observer.h Observer": 54,
    "kernel/longterm/semantic_memory.h SemanticMemory": 54,
    "sml/server/kernel_host.h KernelHost": 46,
    "kernel/memory/working_memory.h WorkingMemory": 46,
    "world/world.h World": 53,
    "world/scene.h Scene": 44,
    "cli/trace_printer.h TracePrinter": 43,
    "sim/actor.h Actor": 40,
    "sml/client/link.h KernelLink": 37,
    "kernel/match/match_set.h MatchSet": 35,
    "kernel/longterm/episodic_memory.h EpisodicMemory": 33,
    "kernel/match/network.h Network": 31,
    "kernel/learn/chunker.h Chunker": 29,
    "kernel/decide/modules.h Modules": 31,
    "kernel/decide/rule_context.h RuleContext": 29,
    "kernel/match/rete.h Rete": 30,
    "sim/simulation.h Simulation": 34,
    "sml/client/client_memory.h WorkingMemory": 31,
    "viewer/viewer.h Viewer": 26,
    "world/physics_world.h PhysicsWorld": 34,
    "world/ui.h Ui": 17,
    "kernel/base/symbol_table.h SymbolTable": 28,
    "kernel/decide/module.h Module": 29,
    "kernel/longterm/episode_store.h EpisodeStore": 27,
    "script/lua_machine.h LuaMachine": 31,
    "sim/soar_mind.h SoarMind": 28,
    "sml/client/local_agent_link.h LocalAgentLink": 26,
    "viewer/viewer_impl.h Impl": 28,
    "kernel/learn/firing_reader.h FiringReader": 25,
    "kernel/longterm/knowledge.h Knowledge": 25,
    "kernel/rules/functions/function_context.h FunctionContext": 24,
    "sml/server/hosted_agent.h HostedAgent": 25,
    "kernel/match/token_pool.h TokenPool": 25,
    "sml/client/link.h AgentLink": 24,
    "sml/server/xml_trace.h XmlTracer": 25,
    "kernel/decide/preference_changes.h PreferenceChanges": 24,
    "kernel/imagery/imagery.h Imagery": 24,
    "sml/client/ElementXML.h ElementXML": 24,
    "sml/client/remote_agent_link.h RemoteAgentLink": 24,
    "sim/minds.h Minds": 25,
    "kernel/match/alpha_memories.h AlphaMemories": 22,
    "kernel/match/sparse_memories.h SparseMemories": 22,
    "script/script_host.h ScriptHost": 28,
    "world/object.h Object": 23,
    "kernel/decide/run_control.h RunControl": 20,
    "sim/arena.h Arena": 23,
    "sml/server/remote_connection.h RemoteConnection": 19,
    "world/agent_store.h AgentStore": 22,
    "app/run_session.h RunSession": 20,
    "kernel/imagery/imagery_scene.h Scene": 20,
    "viewer/render_engine.h Engine": 20,
    "kernel/longterm/wm_activation.h WmActivation": 19,
    "kernel/match/node_states.h NodeStates": 19,
    "cli/session.h Session": 18,
    "kernel/learn/reinforcement.h Reinforcement": 18,
    "world/shared_list.h SharedList": 18,
    "kernel/base/symbol.h Symbol": 17,
    "kernel/imagery/memory_writer.h MemoryWriter": 17,
    "kernel/imagery/imagery_scene.h Node": 17,
    "kernel/io/input_link.h InputLink": 17,
    "bytes/byte_stream.h ByteReader": 17,
    "sml/client/soarbox_Inspection.h MindInspection": 17,
    "cli/print_stream.h PrintStream": 16,
    "kernel/imagery/tracked_list.h TrackedList": 16,
    "kernel/learn/justification.h Justifier": 16,
    "serve/page_session.h Session": 16,
}
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
TEXT = re.compile(r'"(?:\\.|[^"\\\n])*"')
HEAD = re.compile(r"\b(class|struct)\s+(?:\[\[[^\]]*\]\]\s*)?(?:[A-Z]+\s+)?((?:\w+::)*\w+)(?:\s+final)?\s*(?::[^:;{][^;{]*)?\{")
ACCESS = re.compile(r"(public|protected|private)\s*:(?!:)")
NAME = re.compile(r"([~\w]+)\s*\($")


def functions_of(body, name, is_public):
    """The names of the public functions in the text between a class's braces."""
    names, at, depth, statement = set(), 0, 0, ""
    while at < len(body):
        access = ACCESS.match(body, at) if depth == 0 and not statement.strip() else None
        if access:
            is_public = access[1] == "public"
            at = access.end()
            continue
        char = body[at]
        if char == "(" and depth == 0:
            found = NAME.search(statement + "(")
            declares = re.search(r"[\w>&*\]]\s+[&*]*[~\w]+\s*\($", statement + "(")
            if is_public and found and declares and found[1] != name and "operator" not in statement \
                    and not re.match(r"\s*(using|friend|typedef|enum|static_assert)\b", statement):
                names.add(found[1])
            at = end_of(body, at, "(", ")")
            # Skips the rest of the declaration, including its body.
            while at < len(body) and body[at] not in ";{":
                at = end_of(body, at, "(", ")") if body[at] == "(" else at + 1
            at = end_of(body, at, "{", "}") if at < len(body) and body[at] == "{" else at + 1
            statement = ""
            continue
        if char == "{":
            at = end_of(body, at, "{", "}")
            statement += " "
            continue
        statement = "" if char in ";" else statement + char
        at += 1
    return names


def end_of(text, at, opening, closing):
    """The position after the bracket that closes the one at `at`."""
    depth = 0
    for place in range(at, len(text)):
        depth += (text[place] == opening) - (text[place] == closing)
        if depth == 0:
            return place + 1
    return len(text)


def classes_in(text):
    text = TEXT.sub('""', COMMENT.sub("", text))
    for head in HEAD.finditer(text):
        if re.search(r"\benum\s+$", text[:head.start()]):
            continue
        opening = head.end() - 1
        body = text[opening + 1:end_of(text, opening, "{", "}") - 1]
        name = head[2].split("::")[-1]
        yield name, len(functions_of(body, name, head[1] == "struct"))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    faults, counted = [], {}
    for header in sorted(root.glob("**/*.h")):
        file = header.relative_to(root).as_posix()
        if re.match(r"sml/client/sml_", file):
            continue
        for name, count in classes_in(header.read_text()):
            if count > MOST:
                counted[f"{file} {name}"] = count
    for key, count in counted.items():
        if key not in ALLOWED:
            faults.append(f"{key} has {count} public functions; {MOST} are enough: which second concept is in it?")
        elif count > ALLOWED[key]:
            faults.append(f"{key} has {count} public functions and had {ALLOWED[key]}: add no more")
        elif count < ALLOWED[key]:
            print(f"{key} has {count} public functions, fewer than before: write {count} into ALLOWED")
    for key in ALLOWED.keys() - counted.keys():
        print(f"{key} is as small as others now: take it out of ALLOWED")
    if "--list" in sys.argv:
        for key, count in sorted(counted.items(), key=lambda item: (-item[1], item[0])):
            print(f'    "{key}": {count},')
        return 0
    print("\n".join(faults) if faults else f"{len(counted)} classes have more than {MOST} public functions, as many as are allowed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
