source agent.soar
decide indifferent-selection --epsilon-greedy
decide indifferent-selection --epsilon 0
trace 4
run 3
!wme a il int alarm 3
run 2
!update a 4
run 1
print --stack
