sp {init (state <s> ^superstate nil) --> (<s> ^f 1 ^f 2)}
sp {prop (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {rlrule (state <s> ^operator <o> + ^f <f>) (<o> ^name go) --> (<s> ^operator <o> = 0)}
sp {toggle (state <s> ^superstate nil ^operator <o>) (<o> ^name go) (<s> ^reward-link <r>) -(<r> ^reward) --> (<r> ^reward.value 1)}
sp {step (state <s> ^superstate nil ^operator <o>) (<s> -^k 1) --> (<s> ^k 1 ^operator <o> -)}
sp {step2 (state <s> ^superstate nil ^operator <o> ^k 1) --> (<s> ^k 1 -)}
watch 0
rl --set learning on
trace --rl
run 1
print --rl
run 1
print --rl
run 1
print --rl
run 1
print --rl
preferences s1 operator
