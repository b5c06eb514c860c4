# the error of an update is reward and expectation less what was expected
watch 0
soar max-goal-depth 23
decide indifferent-selection --last
decide set-random-seed 92
rl --set learning-policy q-learning
rl --set eligibility-trace-decay-rate 0.5
rl --set decay-mode delta-bar-delta
rl --set learning on
chunk always
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^cell 3 ^color blue ^n 0)}
sp {prop*left (state <s> ^name top ) --> (<s> ^operator <o> + =) (<o> ^name left)}
sp {prop*right (state <s> ^name top ^cell { > 0 }) --> (<s> ^operator <o> + =) (<o> ^name right)}
sp {apply*left (state <s> ^name top ^operator.name left ^cell { <c> > 0 }) --> (<s> ^cell <c> - ^cell (- <c> 1))}
sp {apply*left*wall (state <s> ^name top ^operator.name left ^cell 0) --> (<s> ^cell 0 - ^cell 1)}
sp {apply*right (state <s> ^name top ^operator.name right ^cell { <c> < 4 }) --> (<s> ^cell <c> - ^cell (+ <c> 1))}
sp {apply*right*wall (state <s> ^name top ^operator.name right ^cell 4) --> (<s> ^cell 4 - ^cell 2)}
sp {apply*right*n (state <s> ^name top ^operator.name right ^n <n>) --> (<s> ^n <n> - ^n (+ <n> 1))}
sp {rl*0 (state <s> ^name top ^operator <o> +) --> (<s> ^operator <o> = -1)}
sp {rl*1 (state <s> ^name top ^operator <o> + ^cell <c>) (<o> ^name right) --> (<s> ^operator <o> = -1)}
sp {reward*0 (state <s> ^name top ^reward-link <r> ^operator.name right) --> (<r> ^reward.value 0.25)}
sp {reward*1 (state <s> ^name top ^reward-link <r> ^cell 1) --> (<r> ^reward <w>) (<w> ^value 2)}
sp {reward*2 (state <s> ^name top ^reward-link <r> ^operator.name right) --> (<r> ^reward.value -1)}
sp {gap*prop (state <s> ^name top ^cell 2 -^gapped) --> (<s> ^operator <o> + >) (<o> ^name gap)}
sp {gap*apply (state <s> ^name top ^operator.name gap) --> (<s> ^gapped t)}
sp {gap*undo (state <s> ^name top ^operator.name right ^gapped t) --> (<s> ^gapped t -)}
trace 1
trace --rl
run 8
rl --set learning off
run 2
rl --set learning on
run 2
preferences s1 operator --names
run 4
print --rl
rl --stats
rl
print --rl --full
preferences s1 operator
