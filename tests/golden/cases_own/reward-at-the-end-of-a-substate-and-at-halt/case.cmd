sp {prop (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {propsub (state <s> ^superstate <ss> -^n 3) (<ss> ^operator.name go) --> (<s> ^operator <o> + =) (<o> ^name sub)}
sp {rlsub (state <s> ^operator <o> +) (<o> ^name sub) --> (<s> ^operator <o> = 0)}
sp {rltop (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 0)}
sp {rew (state <s> ^superstate <ss> ^reward-link <r>) (<ss> ^type state) --> (<r> ^reward.value 1)}
sp {rewt (state <s> ^superstate nil ^reward-link <r>) --> (<r> ^reward.value 2)}
sp {app (state <s> ^operator.name sub ^superstate <ss>) --> (<ss> ^fin t)}
sp {hlt (state <s> ^superstate nil ^fin t) --> (halt)}
watch 0
trace --rl
rl --set learning on
run 6
print --rl
