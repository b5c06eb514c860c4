smem --enable
source agent.soar
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
run 1
print -i S1
wm activation --history 17
wm activation --history 20
