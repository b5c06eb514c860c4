source agent.soar
smem --set base-decay 0
smem --set base-decay 8k
smem --get base-decay
smem --set thresh word
smem --get thresh
smem --set spreading on
smem --set activation-mode base-level
smem --set spreading on
smem --get spreading
smem --set base-unused-age-offset 10
smem --get base-unused-age-offset
smem --set spreading-baseline 0
smem --set path a b
smem --set activation-mode
smem --get
epmem --get
epmem --set trigger
epmem --set trigger dc output
epmem --print 1 2
epmem --close now
wm activation --set decay-rate 0
wm activation --get decay-rate
wm activation --set decay-thresh 0
wm activation --set forgetting approx
wm activation --set decay-rate 1 2
