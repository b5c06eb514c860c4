source agent.soar
trace 0
rl --get learning
chunk max-chunks 3.9
chunk max-chunks
chunk max-dupes 12
chunk al
chunk e
chunk m
chunk n
chunk s
chunk o
chunk ne
chunk alw
chunk learn
chunk learn only
chunk l
chunk max-chunks -1
chunk rubbish
explain list-
explain list-c
rl --set
rl --get
rl --set learning
rl --set learning on off
rl --get learning discount-rate
