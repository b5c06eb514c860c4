# what is learned when the deepest goal that there may be is reached
watch 0
decide indifferent-selection --first
rl --set learning on
trace --rl
soar max-goal-depth 4
sp {init (state <s> ^superstate nil) --> (<s> ^name top)}
sp {prop (state <s> ^name top) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {rl*top (state <s> ^name top ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 0.5)}
sp {reward (state <s> ^name top ^reward-link <r>) --> (<r> ^reward.value 1)}
sp {sub (state <s> ^superstate <ss>) (<ss> ^operator.name) --> (<s> ^operator <o> + =) (<o> ^name down)}
sp {rl*sub (state <s> ^superstate <ss> ^operator <o> +) (<o> ^name down) --> (<s> ^operator <o> = 0.25)}
sp {sub*reward (state <s> ^superstate <ss> ^reward-link <r>) (<ss> ^operator.name) --> (<r> ^reward.value 2)}
run 12
print --rl
rl --stats
print --stack
init-soar
run 3
print --rl
