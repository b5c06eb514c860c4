sp {init (state <s> ^superstate nil) --> (<s> ^f 1 ^f 2 ^k 0)}
sp {prop (state <s> ^superstate nil ^k <k>) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {rlrule (state <s> ^operator <o> + ^f <f>) (<o> ^name go) --> (<s> ^operator <o> = 1)}
sp {rltwo (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 1)}
sp {step (state <s> ^superstate nil ^operator <o> ^k <k>) --> (<s> ^k <k> - ^k (+ <k> 1))}
sp {rew (state <s> ^superstate nil ^reward-link <r> ^k) --> (<r> ^reward.value 1)}
watch 0
rl --set learning on
trace --rl
run 2
print --rl
preferences s1 operator
run 1
print --rl
print rlrule
init-soar
print --rl
run 2
print --rl
print rlrule
