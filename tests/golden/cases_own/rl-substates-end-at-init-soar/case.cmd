# a generated agent: at init-soar the substates end, and what their operators are worth is updated
watch 0
decide indifferent-selection --epsilon-greedy
decide set-random-seed 15
rl --set temporal-discount off
rl --set discount-rate 0.99
rl --set chunk-stop off
rl --set apoptosis chunks
rl --set learning on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^cell 4 ^color red ^n 0)}
sp {prop*left (state <s> ^name top ) --> (<s> ^operator <o> +) (<o> ^name left)}
sp {prop*right (state <s> ^name top ^cell { > 0 }) --> (<s> ^operator <o> +) (<o> ^name right)}
sp {indiff (state <s> ^name top ^operator <o> +) --> (<s> ^operator <o> =)}
sp {apply*left (state <s> ^name top ^operator.name left ^cell { <c> > 0 } ^ready t) --> (<s> ^cell <c> - ^cell (- <c> 1))}
sp {apply*left*wall (state <s> ^name top ^operator.name left ^cell 0 ^ready t) --> (<s> ^cell 0 - ^cell 2)}
sp {sub*name (state <s> ^impasse no-change ^superstate <ss>) (<ss> ^operator.name left) --> (<s> ^name sub ^k 0)}
sp {sub*prop*go (state <s> ^name sub ^k { < 2 }) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {sub*apply*go (state <s> ^name sub ^operator.name go ^k <k>) --> (<s> ^k <k> - ^k (+ <k> 1))}
sp {rl*sub*go (state <s> ^name sub ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 0)}
sp {sub*prop*stay (state <s> ^name sub ^k { < 1 }) --> (<s> ^operator <o> + =) (<o> ^name stay)}
sp {sub*apply*stay (state <s> ^name sub ^operator.name stay ^k <k>) --> (<s> ^k <k> - ^k (+ <k> 1))}
sp {rl*sub*stay (state <s> ^name sub ^operator <o> + ^k 0) (<o> ^name stay) --> (<s> ^operator <o> = 10)}
sp {sub*done (state <s> ^name sub ^k { >= 1 } ^superstate <ss>) --> (<ss> ^ready t)}
sp {sub*undo (state <s> ^name top ^operator.name <> left ^ready t) --> (<s> ^ready t -)}
sp {sub*reward (state <s> ^name sub ^reward-link <r> ^k 2) --> (<r> ^reward.value -1)}
sp {apply*right (state <s> ^name top ^operator.name right ^cell { <c> < 4 }) --> (<s> ^cell <c> - ^cell (+ <c> 1))}
sp {apply*right*wall (state <s> ^name top ^operator.name right ^cell 4) --> (<s> ^cell 4 - ^cell 3)}
sp {rl*0 (state <s> ^name top ^operator <o> + ^color red) (<o> ^name left) --> (<s> ^operator <o> = 0.0)}
sp {rl*1 (state <s> ^name top ^operator <o> + ^color red) (<o> ^name right) --> (<s> ^operator <o> = 0)}
sp {num*2 (state <s> ^name top ^operator <o> + ^n <c>) (<o> ^name right) --> (<s> ^operator <o> = (* <c> 0.1))}
sp {tmpl*3 :template (state <s> ^name top ^operator <o> + ^cell <c>) (<o> ^name <nm>) --> (<s> ^operator <o> = 10)}
sp {reward*0 (state <s> ^name top ^reward-link <r> ^cell 4) --> (<r> ^reward <w>) (<w> ^value -1)}
sp {reward*1 (state <s> ^name top ^reward-link <r> ^bump) --> (<r> ^reward.value -2 ^reward <x>) (<x> ^value 1 ^value 3)}
sp {gap*prop (state <s> ^name top ^cell 3 -^gapped) --> (<s> ^operator <o> + >) (<o> ^name gap)}
sp {gap*apply (state <s> ^name top ^operator.name gap) --> (<s> ^gapped t)}
sp {gap*undo (state <s> ^name top ^operator.name right ^gapped t) --> (<s> ^gapped t -)}
trace 1
trace --rl
run 9
init-soar
run 5
print --rl
rl --stats
rl
print --rl --full
print --chunks
preferences s1 operator
print --template
production firing-counts
print -d 2 s1
echo end
