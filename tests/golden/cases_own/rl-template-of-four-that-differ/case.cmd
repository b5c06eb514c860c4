source agent.soar
decide set-random-seed 3
indifferent-selection --first
watch 3
run 1 -e
run 2 -d
print rl*value*take*1
print rl*value*take*2
matches rl*value*take*1
print --rl
run 3 -d
print --rl
