source agent.soar
trace 1
wm activation --set activation on
watch --wma
run 9
trace --wma 0
init-soar
run 2
