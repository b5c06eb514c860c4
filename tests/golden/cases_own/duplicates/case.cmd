source agent.soar
print
rl --set chunk-stop off
sp {number*three (state <s> ^operator <o> +) --> (<s> ^operator <o> = 3)}
rl --set chunk-stop on
sp {number*four (state <s> ^operator <o> +) --> (<s> ^operator <o> = 4)}
sp {number*one (state <s> ^operator <o> +) --> (<s> ^operator <o> = 5)}
sp {call*four (state <s> ^superstate nil) --> (halt) (write | four|)}
print
