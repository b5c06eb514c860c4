sp {prop (state <s> ^superstate nil -^k) --> (<s> ^operator <o> + =) (<o> ^name one)}
sp {rlone (state <s> ^operator <o> +) (<o> ^name one) --> (<s> ^operator <o> = 0)}
sp {app (state <s> ^operator.name one) --> (<s> ^k t)}
sp {prtwo (state <s> ^superstate nil ^k t) --> (<s> ^operator <o> +) (<o> ^name two)}
sp {prthree (state <s> ^superstate nil ^k t) --> (<s> ^operator <o> +) (<o> ^name three)}
sp {rltwo (state <s> ^operator <o> +) (<o> ^name two) --> (<s> ^operator <o> = 4)}
sp {res (state <s> ^impasse tie ^superstate <ss> ^item <o>) (<o> ^name two) --> (<ss> ^operator <o> >)}
sp {rew (state <s> ^superstate nil ^reward-link <r>) --> (<r> ^reward.value 2)}
trace 1
trace --rl
rl --set learning on
run 4
print --rl
init-soar
rl --set hrl-discount on
run 4
print --rl
