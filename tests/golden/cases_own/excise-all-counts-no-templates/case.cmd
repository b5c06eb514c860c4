rl --set learning on
chunk always
decide set-random-seed 3
watch 0
sp {rl*template :template (state <s> ^operator.name <n>) --> (<s> ^operator <n> = 0)}
sp {rl*template :template (state <s> ^operator <o> +) (<o> ^name <n>) --> (<s> ^operator <o> = 0)}
excise --all
print
source agent.soar
run 6
print
excise --all
print
source agent.soar
run 6
excise --user
source agent.soar
excise --templates
excise --default
excise --all
source agent.soar
run 6
excise --rl
excise --chunks
excise --templates
excise --all
chunk never
source agent.soar
run 3
excise --all
source agent.soar
run 3
excise --task
print
excise --never-fired
source agent.soar
run 6
excise --never-fired
print
source agent.soar
excise --never-fired
print
excise --all
