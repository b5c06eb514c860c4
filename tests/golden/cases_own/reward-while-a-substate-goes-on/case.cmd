sp {prop (state <s> ^superstate nil -^fin) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {prop2 (state <s> ^superstate nil ^fin) --> (<s> ^operator <o> + =) (<o> ^name end)}
sp {rltop (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 0)}
sp {rlend (state <s> ^operator <o> +) (<o> ^name end) --> (<s> ^operator <o> = 0)}
sp {propsub (state <s> ^superstate <ss>) (<ss> ^operator.name go) --> (<s> ^operator <o> + =) (<o> ^name sub)}
sp {rew (state <s> ^superstate nil ^reward-link <r>) --> (<r> ^reward.value 2)}
sp {app (state <s> ^operator.name sub ^superstate <ss>) --> (<ss> ^fin t)}
watch 0
trace --rl
rl --set learning on
run 6
print --rl
