sp {init (state <s> ^superstate nil) --> (<s> ^v 5)}
sp {prop (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name go)}
sp {rv (state <s> ^operator <o> + ^v <v>) (<o> ^name go) --> (<s> ^operator <o> = <v>)}
sp {two (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 5 ^w t)}
sp {three (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 5)}
sp {four (state <s> ^operator <o> + ^v 5) (<o> ^name go) --> (<s> ^operator <o> = (+ 1 2))}
watch 0
rl --set learning on
run 2
print --rl
preferences s1 operator
