source agent.soar
run 3
excise -a unseen
excise unseen -a
excise unseen large
alias -r a b
alias one print s1
alias -r one
one
fc 0
fc 1.5
fc -f
matches -a unseen
matches unseen -t -n
matches -r unseen
pwatch add*apply
pwatch begin*apply
pwatch
chunk --sometimes
chunk -x -y
stats all
output print-depth 1.5
output print-depth
output agent-logs 0 on
output agent-logs 1 maybe
excise -n
print
