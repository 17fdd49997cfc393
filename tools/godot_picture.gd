# Saves what a scene of a Godot 3 project shows: godot3 --path PROJECT -s godot_picture.gd SCENE PICTURE
extends SceneTree


func _init():
	var arguments = OS.get_cmdline_args()
	var count = arguments.size()
	get_root().add_child(load(arguments[count - 2]).instance())
	# Sky and shadows are there in the second frame.
	for _frame in 3:
		yield(VisualServer, "frame_post_draw")
	var picture = get_root().get_texture().get_data()
	picture.flip_y()
	picture.save_png(arguments[count - 1])
	quit()
