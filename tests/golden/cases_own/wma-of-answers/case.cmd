source agent.soar
run 5
print s1 --depth 4 --internal
run 1
print s1 --depth 4 --internal
wm activation --history 40
wm activation --history 42
wm activation --history 44
run 2
wm activation --history 42
