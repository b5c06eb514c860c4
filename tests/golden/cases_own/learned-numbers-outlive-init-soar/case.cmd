sp {prop (state <s> ^superstate nil -^x) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {rlrule (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 2)}
sp {app (state <s> ^operator <o>) --> (<s> ^x t)}
sp {rew (state <s> ^reward-link <r>) --> (<r> ^reward.value 1)}
sp {prop2 (state <s> ^superstate nil ^x) --> (<s> ^operator <o> + =) (<o> ^name stop)}
watch 0
rl --set learning on
run 3
print --rl
print rlrule
print -f rlrule
init-soar
print --rl
run 3
print --rl
rl
