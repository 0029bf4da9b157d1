# picture of top_foil
