source agent.soar
print pairs*1
print pairs*2
print pairs*3
print pairs*4
print parts*1
print parts*2
soar stop-phase decision
soar stop-phase
soar stop-phase output
soar stop-phase
run -p
run -p
soar
